// The scale of the errors: its colours, its end, and whether the visitor chose it.
import { element } from "./elements.js";
import { colours, counted, tidy } from "./numbers.js";

/** @typedef {import("./pkg/comparison.js").Comparison} Comparison */

export class ErrorScale {
  #comparison;
  #select = element("scale", HTMLSelectElement);
  #legend = element("legend");
  #note = element("scale-note");

  /** Called when the visitor chooses another scale. */
  onchange = () => {};

  /**
   * @param {Comparison} comparison
   * @param {Iterable<number>} ends
   */
  constructor(comparison, ends) {
    this.#comparison = comparison;
    this.#select.add(new Option("automatic", ""));
    for (const end of ends) this.#select.add(new Option(counted(end, "code"), String(end)));
    this.#select.addEventListener("input", () => {
      comparison.setScale(this.#select.value === "" ? undefined : Number(this.#select.value));
      this.onchange();
    });
    this.#legend.style.background = `linear-gradient(90deg, ${colours(comparison.palette()).join()})`;
  }

  /** Shows the scale in force. */
  show() {
    const { scale, gain } = this.#comparison;
    element("tick-middle").textContent = String(tidy(scale / 2));
    element("tick-end").textContent = scale === 255 ? "255 codes" : `${counted(scale, "code")} or more`;
    const why = this.#select.value === "" ? "so that both sides fit" : "as chosen";
    const times = Number(gain.toPrecision(3)).toLocaleString("en");
    const size = gain === 1 ? "at their size" : `magnified ${times} times`;
    this.#note.textContent = `Errors in 8-bit sRGB codes, ${size}, ${why}. A ring marks the largest.`;
    this.#legend.setAttribute("aria-label", `From no error, dark blue, to ${counted(scale, "code")}, pale yellow`);
  }
}
