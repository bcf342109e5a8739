// The comparison: two forms of one beam, each compared with f64.
import { Comparison, initSync } from "./pkg/comparison.js";
import { remember } from "./address.js";
import { Divider } from "./divider.js";
import { element, encircle, find } from "./elements.js";
import { ErrorScale } from "./error-scale.js";
import { refusalOf } from "./failure.js";
import { Frame } from "./frame.js";
import { Ledger } from "./ledger.js";
import { compile } from "./module.js";
import { degrees, exact } from "./numbers.js";
import { plain } from "./plain.js";
import { PriceList } from "./price-list.js";
import { ToldDial } from "./told-dial.js";

/** Pixels on a side: enough to see the rings of a beam whose precision is exhausted. */
const SIZE = 400;

const SIDES = [0, 1];

/** @typedef {import("./ledger.js").State} State */

/**
 * The element of a side.
 * @template {Element} [T=HTMLElement]
 * @param {string} name
 * @param {number} side
 * @param {abstract new (...args: any) => T} [kind]
 */
const on = (name, side, kind) => element(`${name}-${side}`, kind);

/**
 * Formats a distance in metres with a common unit.
 * @param {number} metres
 */
function far(metres) {
  if (metres < 1) return `${Math.round(100 * metres)} cm`;
  return metres < 1000 ? `${Number(metres.toPrecision(3))} m` : `${Number((metres / 1000).toPrecision(3))} km`;
}

/**
 * Shows pictures by whole numbers of the device's pixels: a pixel of an error map is then a square of
 * one colour. Where there is no room for that, pictures fill their place.
 * @param {Element} exhibit
 */
function scale(exhibit) {
  const whole = Math.floor((exhibit.clientWidth * devicePixelRatio) / SIZE);
  const width = whole > 0 ? `${(whole * SIZE) / devicePixelRatio}px` : "100%";
  const { style } = /** @type {HTMLElement} */ (exhibit);
  style.setProperty("--whole", width);
}

export class ComparisonView {
  #comparison;
  #forms;
  #halfAngle;
  #scale;
  #ledger;
  #frame = new Frame(() => this.#draw());
  /** The rejected choices of the address, for each side. */
  #unknown = ["", ""];

  /** How many times the pictures have been drawn. */
  drawn = 0;

  /** Loads the module and the price list. */
  static async open() {
    const [prices, module] = await Promise.all([PriceList.load(), compile(new URL("pkg/comparison_bg.wasm", import.meta.url))]);
    initSync({ module });
    return new ComparisonView(prices);
  }

  /** @param {PriceList} prices */
  constructor(prices) {
    /** @type {(name: string, side: number) => HTMLCanvasElement} */
    const canvas = (name, side) => on(name, side, HTMLCanvasElement);
    const [first, second] = SIDES.map((side) => /** @type {const} */ ([canvas("picture", side), canvas("errors", side)]));
    this.#comparison = new Comparison(...first, ...second, SIZE);
    this.#forms = new Map(Comparison.forms().map((form) => [form.name, form]));
    this.#halfAngle = new ToldDial({ slider: "half-angle", number: "half-angle-number", error: "half-angle-error" }, (value) => {
      this.#comparison.setHalfAngle(value);
      this.#frame.request();
    });
    this.#halfAngle.range(exact(Comparison.narrowest()), exact(Comparison.widest()), "°");
    this.#scale = new ErrorScale(this.#comparison, Comparison.scales());
    this.#scale.onchange = () => this.#frame.request();
    this.#ledger = new Ledger(this.#comparison, this.#forms, prices);
    new Divider(element("comparison"));
    // In the next frame: a change of size within this one would be an error of the observer.
    const observer = new ResizeObserver((changes) => {
      requestAnimationFrame(() => changes.forEach(({ target }) => scale(target)));
    });
    for (const exhibit of document.querySelectorAll(".exhibit")) observer.observe(exhibit);
    for (const side of SIDES) this.#joinSide(side);
  }

  /**
   * Applies the address, such as `left=f32&right=fx16&half=0.6`. Refusals are shown.
   * @param {string} text
   */
  show(text) {
    const query = new URLSearchParams(text);
    for (const [side, name] of ["left", "right"].entries()) this.#ask(side, query.get(name));
    this.#halfAngle.show(exact(this.#comparison.halfAngle));
    const half = query.get("half");
    if (half !== null) this.#halfAngle.take(half.trim() === "" ? NaN : Number(half));
    this.#frame.draw();
  }

  /** Draws on canvases that the browser has emptied. */
  restore() {
    this.#frame.draw();
  }

  /** Called when the view is hidden. */
  hide() {
    this.#frame.cancel();
    this.#ledger.stop();
  }

  /** The state of both sides as plain objects. */
  get sides() {
    return SIDES.map((side) => plain(this.#comparison.side(side)));
  }

  /**
   * Sets a form by the name in the address, if there is one.
   * @param {number} side
   * @param {string | null} name
   */
  #ask(side, name) {
    this.#unknown[side] = name === null ? "" : refusalOf(() => this.#comparison.setForm(side, name));
  }

  /** Resolves when the current pictures have been timed. */
  get measured() {
    return this.#ledger.measured;
  }

  /** @param {number} side */
  #joinSide(side) {
    const select = on("form", side, HTMLSelectElement);
    for (const { name, label } of this.#forms.values()) select.add(new Option(label, name));
    select.addEventListener("input", () => {
      this.#ask(side, select.value);
      this.#frame.request();
    });
    on("widen", side).addEventListener("click", () => {
      this.#halfAngle.take(exact(this.sides[side]?.narrowest ?? NaN));
      // The button disappears, and the focus with it.
      element("half-angle").focus();
    });
  }

  #draw() {
    this.#comparison.draw();
    const states = this.sides;
    for (const [side, state] of states.entries()) this.#tell(side, state);
    const { beam, field, distance } = this.#comparison;
    element("beam-note").textContent =
      `Full angles: beam ${degrees(beam)}, field ${degrees(field)}. The wall is ${far(distance)} away, ` +
      "so that the spot on it keeps its radius of one metre.";
    this.#scale.show();
    this.#ledger.show(states);
    this.#remember(states);
    this.drawn += 1;
  }

  /**
   * @param {number} side
   * @param {State} state
   */
  #tell(side, state) {
    const label = this.#forms.get(state.form)?.label;
    const refused = state.refusal !== undefined;
    const select = on("form", side, HTMLSelectElement);
    select.value = state.form;
    select.setAttribute("aria-invalid", String(refused));
    on("refusal", side).textContent = this.#unknown[side] || (state.refusal ?? "");
    on("refusal-badge", side).hidden = on("refusal", side).textContent === "";
    on("widen", side).hidden = state.narrowest === undefined;
    if (state.narrowest !== undefined) on("widen", side).textContent = `Widen to ${exact(state.narrowest)}°`;
    for (const half of document.querySelectorAll(`#comparison .half[data-side="${side}"]`)) {
      half.classList.toggle("is-refused", refused);
      find(half, ".missing").hidden = !refused;
    }
    on("picture", side).setAttribute("aria-label", `The beam in ${label}`);
    on("errors", side).setAttribute("aria-label", `What ${label} differs from f64 by`);
    encircle(on("spot", side), (state.largest ?? 0) > 0, state.place, { width: SIZE, height: SIZE });
  }

  /**
   * Updates the address, so that it can be shared.
   * @param {State[]} states
   */
  #remember([left, right]) {
    const half = String(exact(this.#comparison.halfAngle));
    const query = new URLSearchParams({ left: left.form, right: right.form, half });
    remember("compare", () => query.toString());
  }
}
