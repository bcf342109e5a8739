// The place of the price on the stage. What fills it is loaded when it comes into view.
import { element, made, onceSeen } from "./elements.js";
import { load } from "./support.js";
import { words } from "./failure.js";
import { median, tidy } from "./numbers.js";
import { built } from "./parts.js";

/**
 * A light, with its number in a job of the stage as it is now, and the distances of the surfaces that it reaches: the
 * nearest and the farthest, or none.
 * @typedef {import("./plain.js").Plain<import("./pkg/wasm_demo.js").LightState>
 *   & { job: () => string, number: number, distances: () => number[] }} Light
 */

/** Pictures whose median is shown. */
const PICTURES = 30;

export class PriceSlot {
  #place = element("price");
  /** @type {import("./price-panel.js").PricePanel | undefined} */
  #panel;
  /**
   * The light, unless there is none, and the number format.
   * @type {[Light | undefined, string] | undefined}
   */
  #light;
  /**
   * Nanoseconds a lit point of the last pictures.
   * @type {number[]}
   */
  #times = [];
  #live = "";

  /** Called with the number format that the visitor has chosen in the chart. */
  onformat = /** @type {(format: string) => void} */ (() => {});

  constructor() {
    onceSeen([this.#place], () => this.#open());
  }

  /** What fills the place; undefined until it is loaded. */
  get panel() {
    return this.#panel;
  }

  /**
   * Shows the price of a light in the number format of the stage.
   * @param {Light | undefined} light whose intensity is a multiple of full scale at one metre
   * @param {string} format
   */
  show(light, format) {
    if (format !== this.#light?.[1]) this.#times = [];
    this.#light = [light, format];
    this.#panel?.show(light, format);
  }

  /**
   * Adds what a picture took.
   * @param {number} lighting the time that all workers have lit it, in milliseconds
   * @param {import("./pool.js").Account} account of the picture
   */
  add(lighting, { evaluated, evaluatedInAir }) {
    if (evaluated === 0) return;
    this.#times.push((1e6 * lighting) / evaluated);
    if (this.#times.length > PICTURES) this.#times.shift();
    const haze = evaluatedInAir > 0 ? ", haze included" : "";
    this.#live = `On this machine, ${tidy(median(this.#times))} ns of a core for a lit point${haze}`;
    this.#panel?.live(this.#live);
  }

  async #open() {
    const told = made("p", { className: "note", role: "status" });
    this.#place.replaceChildren(told);
    try {
      await built("price", (text) => (told.textContent = text));
      await built("code", (text) => (told.textContent = text));
      const { PricePanel } = await load("price-panel.js");
      /** @type {import("./price-panel.js").PricePanel} */
      const panel = await PricePanel.open(this.#place);
      this.#panel = panel;
      panel.onformat = (format) => this.onformat(format);
      if (this.#light) panel.show(...this.#light);
      panel.live(this.#live);
    } catch (error) {
      const again = made("button", {}, "Try again");
      again.addEventListener("click", () => this.#open());
      this.#place.replaceChildren(`The price can't be shown: ${words(error)} `, again);
    }
  }
}
