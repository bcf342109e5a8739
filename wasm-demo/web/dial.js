// A slider and a number beside it, for one value.
import { tidy } from "./numbers.js";

/**
 * The slider offers what is taken. Anything can be typed into the number, so that the kernel can say what is wrong
 * with it.
 */
export class Dial {
  #slider;
  #number;

  /**
   * @param {HTMLInputElement} slider
   * @param {HTMLInputElement} number
   * @param {(value: number, control: HTMLInputElement) => void} set called as the value changes; NaN for no number
   */
  constructor(slider, number, set) {
    this.#slider = slider;
    this.#number = number;
    for (const control of [slider, number]) {
      control.addEventListener("input", () => set(control.valueAsNumber, control));
    }
  }

  /** Sets the ends of the slider. */
  range(least, most) {
    this.#slider.min = least;
    this.#slider.max = most;
  }

  /**
   * Shows a value, except on the control that it comes from: nobody wants his text rewritten while he types.
   * @param {number} value
   * @param {Element} [source]
   */
  show(value, source) {
    for (const control of [this.#slider, this.#number]) {
      if (control !== source) control.value = tidy(value);
    }
    const { min, max } = this.#slider;
    const part = (value - min) / (max - min);
    this.#slider.style.setProperty("--part", `${100 * Math.min(Math.max(part, 0), 1)}%`);
  }
}
