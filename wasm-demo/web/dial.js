// A slider and a number beside it, for one value.
import { tidy } from "./numbers.js";

/**
 * Connects a number field: `set` gets the typed value; `leave` is called when there is nothing to
 * set.
 */
export function joinNumber(field, set, leave) {
  field.addEventListener("input", () => {
    // An empty field is about to be filled. The browser returns NaN for any other invalid text.
    if (field.value === "" && !field.validity.badInput) leave(field);
    else set(field.valueAsNumber, field);
  });
  field.addEventListener("blur", () => leave());
}

/**
 * The slider covers the valid range. The number field accepts any text, so that the kernel can
 * explain what is wrong with a value.
 */
export class Dial {
  #slider;
  #number;

  /**
   * @param {HTMLInputElement} slider
   * @param {HTMLInputElement} number
   * @param {(value: number, control: HTMLInputElement) => void} set called on a change, NaN for no number
   * @param {(number: HTMLInputElement, source?: HTMLInputElement) => void} leave called when
   *   the number is empty, with itself as the source, and when it loses focus: its refusal ends, and
   *   it shows the current value
   */
  constructor(slider, number, set, leave) {
    this.#slider = slider;
    this.#number = number;
    slider.addEventListener("input", () => set(slider.valueAsNumber, slider));
    joinNumber(number, set, (source) => leave(number, source));
  }

  /** Sets the ends of the slider. */
  range(least, most) {
    this.#slider.min = least;
    this.#slider.max = most;
  }

  /**
   * Shows a value, except on the control that it comes from: nobody wants his text rewritten while
   * he types.
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
