// The scale of the errors: its colours, its end, and whether the visitor chose it.
import { colours, tidy } from "./numbers.js";

export class ErrorScale {
  #comparison;
  #select = document.getElementById("scale");
  #legend = document.getElementById("legend");
  #note = document.getElementById("scale-note");

  /** Called when the visitor chooses another scale. */
  onchange = () => {};

  constructor(comparison, ends) {
    this.#comparison = comparison;
    this.#select.add(new Option("automatic", ""));
    for (const end of ends) this.#select.add(new Option(counted(end), end));
    this.#select.addEventListener("input", () => {
      comparison.setScale(this.#select.value === "" ? undefined : Number(this.#select.value));
      this.onchange();
    });
    this.#legend.style.background = `linear-gradient(90deg, ${colours(comparison.palette()).join()})`;
  }

  /** Shows the scale in force. */
  show() {
    const { scale, gain } = this.#comparison;
    document.getElementById("tick-middle").textContent = tidy(scale / 2);
    document.getElementById("tick-end").textContent = scale === 255 ? "255 codes" : `${counted(scale)} or more`;
    const why = this.#select.value === "" ? "so that both sides fit" : "as chosen";
    const times = Number(gain.toPrecision(3)).toLocaleString("en");
    const size = gain === 1 ? "at their size" : `magnified ${times} times`;
    this.#note.textContent = `Errors in 8-bit sRGB codes, ${size}, ${why}. A ring marks the largest.`;
    this.#legend.setAttribute("aria-label", `From no error, dark blue, to ${counted(scale)}, pale yellow`);
  }
}

/** Formats a number of codes. */
const counted = (codes) => `${codes} ${codes === 1 ? "code" : "codes"}`;
