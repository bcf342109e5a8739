// The museum: faulty spotlights of other projects, beside the exact light and the crate's.
import { Museum, initSync } from "./pkg/comparison.js";
import { remember } from "./address.js";
import { copyOf, element as byId, encircle, find, made, styled } from "./elements.js";
import { aside, hasFailed, refusalOf } from "./failure.js";
import { Frame } from "./frame.js";
import { compile } from "./module.js";
import { colours, counted, exact, tidy } from "./numbers.js";
import { ToldDial } from "./told-dial.js";

/** Pixels on a side of a picture; fewer where two stand beside each other on a telephone. */
const SIZE = { roomy: 300, wide: 200, narrow: 160 };
const THUMBNAIL = 48;

const SIDES = [0, 1];

/** @typedef {import("./pkg/comparison.js").ExhibitState} Exhibit */

/** What is shown of an exhibit as it is. */
const TEXTS = /** @type {const} */ ([
  "title", "code", "cause", "noBetter", "project", "file", "version", "licence", "thread",
]);

/** @param {string} name */
const element = (name) => byId(`exhibit-${name}`);
/** @param {string} name */
const input = (name) => byId(`exhibit-${name}`, HTMLInputElement);
/** @param {string} name */
const button = (name) => byId(`exhibit-${name}`, HTMLButtonElement);
/** @type {(name: string, side: number) => HTMLElement} */
const on = (name, side) => element(`${name}-${side}`);

/**
 * Formats an error in linear codes.
 * @param {number} value
 */
function codes(value) {
  if (value < 0.001) return "under 0.001 codes";
  return counted(value < 10 ? Number(value.toPrecision(2)) : Math.round(value), "code");
}

/** The side of a picture for which the window has room. */
function room() {
  if (innerWidth >= 1700 && innerHeight >= 1000) return SIZE.roomy;
  return innerWidth < 560 ? SIZE.narrow : SIZE.wide;
}

export class MuseumView {
  #exhibits = new Map(Museum.exhibits().map((exhibit) => [exhibit.name, exhibit]));
  #size = room();
  #museum;
  #dial;
  #frame = new Frame(() => this.#draw());

  /** How many times the pictures have been drawn. */
  drawn = 0;

  static async open() {
    const [module] = await Promise.all([compile(new URL("pkg/comparison_bg.wasm", import.meta.url)), styled("museum.css")]);
    // After the comparison this changes nothing.
    initSync({ module });
    return new MuseumView();
  }

  constructor() {
    /** @type {(name: string) => HTMLCanvasElement} */
    const canvas = (name) => byId(`exhibit-${name}`, HTMLCanvasElement);
    this.#museum = new Museum(canvas("picture-0"), canvas("errors-0"), canvas("picture-1"), canvas("errors-1"), this.#size);
    this.#dial = new ToldDial({ slider: "exhibit-value", number: "exhibit-number", error: "exhibit-error" }, (value) => {
      this.#museum.setValue(value);
      this.#frame.request();
    });
    for (const exhibit of this.#exhibits.values()) this.#list(exhibit);
    for (const name of ["start", "agrees"]) {
      button(name).addEventListener("click", () => this.#dial.take(Number(button(name).value)));
    }
    element("legend").style.background = `linear-gradient(90deg, ${colours(this.#museum.palette()).join()})`;
    element("undefined").style.background = colours(Museum.undefined())[0] ?? "";
    this.#drawThumbnails([...this.#exhibits.keys()]);
  }

  /**
   * Applies the address, such as `exhibit=gltf&at=2`. Refusals are shown.
   * @param {string} text
   */
  show(text) {
    const query = new URLSearchParams(text);
    const name = query.get("exhibit") ?? this.#museum.exhibit;
    this.#dial.tell(refusalOf(() => this.#museum.open(name)));
    this.#showExhibit();
    const at = query.get("at");
    if (at === null) this.#frame.draw();
    else this.#dial.take(at.trim() === "" ? NaN : Number(at));
    if (this.drawn === 0) this.#frame.draw();
  }

  /** Draws on canvases that the browser has emptied. */
  restore() {
    this.#frame.draw();
    this.#drawThumbnails([...this.#exhibits.keys()]);
  }

  /** Called when the view is hidden. */
  hide() {
    this.#frame.cancel();
  }

  /** The state for tests: the exhibit, its control and the errors of both pictures. */
  get state() {
    const { exhibit, value, format, scale } = this.#museum;
    return { exhibit, value: exact(value), format, scale, sides: SIDES.map((side) => this.#museum.side(side)) };
  }

  /** The names of the exhibits. */
  get names() {
    return [...this.#exhibits.keys()];
  }

  /** @param {Exhibit} exhibit */
  #list({ name, label }) {
    const item = copyOf("exhibit");
    const choice = find(item, "input", HTMLInputElement);
    choice.id = `exhibit-of-${name}`;
    choice.value = name;
    find(item, "span").textContent = label;
    choice.addEventListener("input", () => this.show(new URLSearchParams({ exhibit: name }).toString()));
    element("list").append(item);
  }

  /**
   * Draws one small picture with each frame of the browser.
   * @param {string[]} names
   */
  #drawThumbnails([name, ...rest]) {
    if (name === undefined || hasFailed()) return;
    aside(() => {
      const canvas = find(held(input(`of-${name}`)), "canvas", HTMLCanvasElement);
      canvas.width = canvas.height = THUMBNAIL;
      const pixels = /** @type {Uint8ClampedArray<ArrayBuffer>} */ (Museum.thumbnail(name, THUMBNAIL));
      const image = new ImageData(pixels, THUMBNAIL, THUMBNAIL);
      canvas.getContext("2d")?.putImageData(image, 0, 0);
    });
    requestAnimationFrame(() => this.#drawThumbnails(rest));
  }

  /** Shows what does not change with the control. */
  #showExhibit() {
    const exhibit = this.#exhibit;
    const chosen = input(`of-${exhibit.name}`);
    chosen.checked = true;
    for (const name of TEXTS) element(name).textContent = exhibit[name];
    element("thread").replaceChildren(...linked(exhibit.thread));
    held(element("thread")).hidden = exhibit.thread === "";
    element("control").textContent = exhibit.control;
    element("unit").textContent = exhibit.unit;
    element("number").setAttribute("aria-label", `${exhibit.control}${exhibit.unit && `, ${exhibit.unit}`}`);
    this.#dial.range(exact(exhibit.least), exact(exhibit.most), exhibit.unit, exhibit.isLogarithmic);
    this.#dial.show(exact(this.#museum.value));
    button("start").value = String(exact(exhibit.start));
    element("start").textContent = `Show the fault: ${told(exhibit.start, exhibit.unit)}`;
    element("agrees").hidden = exhibit.agreesAt === undefined;
    if (exhibit.agreesAt === undefined) return;
    button("agrees").value = String(exact(exhibit.agreesAt));
    element("agrees").textContent = `Show where both agree: ${told(exhibit.agreesAt, exhibit.unit)}`;
  }

  #draw() {
    this.#museum.draw();
    const { exhibit, value, format, scale, sides } = this.state;
    const { label } = this.#exhibit;
    for (const [side, { largest, undefined: lost, place }] of sides.entries()) {
      const share = Number(((100 * lost) / this.#size ** 2).toPrecision(2));
      on("largest", side).textContent = lost === 0 ? codes(largest) : `NaN, ${share} % of the pixels`;
      on("picture", side).setAttribute("aria-label", side === 0 ? `${label}, as published` : "The same beam by luminaire");
      on("errors", side).setAttribute("aria-label", `Largest error: ${on("largest", side).textContent}`);
      encircle(on("ring", side), largest > 0.5, place, { width: this.#size, height: this.#size });
    }
    element("format").textContent = format;
    element("end").textContent = `${codes(scale)}${(sides[0]?.largest ?? 0) > scale ? " or more" : ""}`;
    element("lost").hidden = sides.every((side) => side.undefined === 0);
    remember("museum", () => new URLSearchParams({ exhibit, at: String(value) }).toString());
    this.drawn += 1;
  }

  /** The exhibit that is shown. */
  get #exhibit() {
    return /** @type {Exhibit} */ (this.#exhibits.get(this.#museum.exhibit));
  }
}

/**
 * A value with its unit: only a degree is without a space.
 * @param {number} value
 * @param {string} unit
 */
const told = (value, unit) => `${tidy(exact(value))}${unit && (unit === "°" ? "" : " ")}${unit}`;

/**
 * The element that holds another.
 * @param {Element} element
 */
const held = (element) => /** @type {HTMLElement} */ (element.parentElement);

/**
 * The names of threads, such as `owner/repository #1, #2`, as links to their host.
 * @param {string} threads
 */
function linked(threads) {
  let project = "";
  return threads.split(/([\w.-]+\/[\w.-]+ #\d+|#\d+)/).map((text) => {
    const [, named, number] = /^(?:(\S+) )?#(\d+)$/.exec(text) ?? [];
    project = named ?? project;
    return number ? made("a", { href: `https://github.com/${project}/issues/${number}` }, text) : text;
  });
}
