// Elements of the page.

/**
 * Returns the element with an id. The page is broken if it has none, or one of another kind.
 * @template {Element} [T=HTMLElement]
 * @param {string} id
 * @param {abstract new (...args: any) => T} [kind]
 * @returns {T}
 */
export function element(id, kind = /** @type {any} */ (HTMLElement)) {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`#${id} = ${found}: expected one ${kind.name}`);
  return found;
}

/**
 * Returns the first element that a selector finds in another.
 * @template {Element} [T=HTMLElement]
 * @param {ParentNode} within
 * @param {string} selector
 * @param {abstract new (...args: any) => T} [kind]
 * @returns {T}
 */
export function find(within, selector, kind = /** @type {any} */ (HTMLElement)) {
  const found = within.querySelector(selector);
  if (!(found instanceof kind)) throw new Error(`${selector} = ${found}: expected one ${kind.name}`);
  return found;
}

/**
 * Returns a copy of the one element that a template holds.
 * @param {string} id
 */
export function copyOf(id) {
  return /** @type {HTMLElement} */ (element(id, HTMLTemplateElement).content.firstElementChild?.cloneNode(true));
}

/**
 * Loads the text of a file beside the scripts.
 * @param {string} file
 */
export async function fetchText(file) {
  const answer = await fetch(new URL(file, import.meta.url));
  if (!answer.ok) throw new Error(`${file}: the server answers ${answer.status}`);
  return answer.text();
}

/**
 * Loads a style sheet beside the scripts. Without its style a view is plain and still right.
 * @param {string} file
 */
export function styled(file) {
  const sheet = made("link", { rel: "stylesheet", href: new URL(file, import.meta.url).href });
  document.head.append(sheet);
  return new Promise((resolve) => (sheet.onload = sheet.onerror = resolve));
}

/**
 * Creates an element.
 * @template {keyof HTMLElementTagNameMap} Kind
 * @param {Kind} kind
 * @param {object} properties
 * @param {(Node | string)[]} within
 */
export function made(kind, properties, ...within) {
  const element = Object.assign(document.createElement(kind), properties);
  element.append(...within);
  return element;
}

/**
 * Fills the part of a slider's track that is before its value.
 * @param {HTMLInputElement} slider
 */
export function showPart(slider) {
  const [min, max] = [Number(slider.min), Number(slider.max)];
  slider.style.setProperty("--part", `${(100 * (slider.valueAsNumber - min)) / (max - min)}%`);
}

/**
 * Creates a row of a table.
 * @param {string | undefined} head its name, if it has one
 * @param {string[]} texts of its cells
 * @param {"td" | "th"} [kind] of its cells
 */
export function row(head, texts, kind = "td") {
  const heads = head === undefined ? [] : [made("th", { scope: "row" }, head)];
  return made("tr", {}, ...heads, ...texts.map((text) => made(kind, {}, text)));
}

/**
 * Puts a ring around a pixel of a picture, or hides it.
 * @param {HTMLElement} ring
 * @param {boolean} isShown
 * @param {number} place the index of the pixel, row by row
 * @param {{ width: number, height: number }} size of the picture
 */
export function encircle(ring, isShown, place, { width, height }) {
  ring.hidden = !isShown;
  ring.style.left = `${(100 * ((place % width) + 0.5)) / width}%`;
  ring.style.top = `${(100 * (Math.floor(place / width) + 0.5)) / height}%`;
}

/**
 * Calls `act` once, when one of the elements comes into view.
 * @param {Element[]} elements
 * @param {() => void} act
 */
export function onceSeen(elements, act) {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    act();
  });
  for (const element of elements) observer.observe(element);
}
