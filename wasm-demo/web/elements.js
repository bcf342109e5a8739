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
 * Fills the part of a slider's track that is before its value.
 * @param {HTMLInputElement} slider
 */
export function showPart(slider) {
  const [min, max] = [Number(slider.min), Number(slider.max)];
  slider.style.setProperty("--part", `${(100 * (slider.valueAsNumber - min)) / (max - min)}%`);
}
