// The half angle of the beam: a logarithmic slider and a number.
import { joinNumber } from "./dial.js";
import { degrees, tidy } from "./numbers.js";

/** Rounds to three significant digits; the slider would give a dozen. */
const round = (value) => Number(value.toPrecision(3));

/**
 * The slider covers the valid range. The number field accepts any text; invalid values are refused
 * with a message.
 */
export class HalfAngle {
  #slider = document.getElementById("half-angle");
  #number = document.getElementById("half-angle-number");
  #error = document.getElementById("half-angle-error");
  #set;
  #ends;
  /** The current value. */
  #value;

  /**
   * @param {[number, number]} ends the narrowest and the widest, in degrees
   * @param {(degrees: number) => void} set called on a change, NaN for no number; may throw
   */
  constructor(ends, set) {
    this.#set = set;
    this.#ends = ends;
    [this.#slider.min, this.#slider.max] = ends.map(Math.log10);
    this.#slider.addEventListener("input", () => this.take(this.#ofSlider(), this.#slider));
    joinNumber(
      this.#number,
      (value) => this.take(value, this.#number),
      (source) => {
        this.#tell("");
        this.show(this.#value, source);
      },
    );
  }

  /** Shows a value, except on the control that it comes from. */
  show(value, source) {
    this.#value = value;
    if (source !== this.#number) this.#number.value = tidy(value);
    if (source !== this.#slider) this.#slider.value = Math.log10(value);
    const { min, max } = this.#slider;
    this.#slider.style.setProperty("--part", `${(100 * (Math.log10(value) - min)) / (max - min)}%`);
    this.#slider.setAttribute("aria-valuetext", degrees(value));
  }

  /** Sets a half angle in degrees. A refusal is shown and changes nothing else. */
  take(value, source) {
    let refusal = "";
    try {
      this.#set(value);
    } catch (error) {
      if (typeof error !== "string") throw error;
      refusal = error;
    }
    this.#tell(refusal);
    if (refusal === "") this.show(value, source);
  }

  #tell(refusal) {
    this.#error.textContent = refusal;
    this.#number.setAttribute("aria-invalid", refusal !== "");
  }

  #ofSlider() {
    const [narrowest, widest] = this.#ends;
    return Math.min(Math.max(round(10 ** this.#slider.valueAsNumber), narrowest), widest);
  }
}
