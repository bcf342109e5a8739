// A slider, linear or logarithmic, and a number beside it, for one value.
import { joinNumber } from "./dial.js";
import { tidy } from "./numbers.js";

export class Slider {
  #slider;
  #number;
  #unit = "";
  #ends = [0, 1];
  #isLogarithmic = false;
  #value = 0;

  /**
   * @param {HTMLInputElement} slider
   * @param {HTMLInputElement} number
   * @param {(value: number, source: HTMLInputElement) => void} set called on a change, NaN for no number
   */
  constructor(slider, number, set) {
    this.#slider = slider;
    this.#number = number;
    slider.addEventListener("input", () => set(this.#ofPlace(slider.valueAsNumber), slider));
    joinNumber(number, set, (source) => this.show(this.#value, source));
  }

  /**
   * Sets the ends; those of a logarithmic slider are more than 0.
   * @param {number} least
   * @param {number} most
   * @param {boolean} isLogarithmic
   * @param {string} unit
   */
  range(least, most, isLogarithmic, unit) {
    this.#ends = [least, most];
    this.#isLogarithmic = isLogarithmic;
    this.#unit = unit;
    [this.#slider.min, this.#slider.max] = this.#ends.map((end) => String(this.#place(end)));
  }

  /**
   * Shows a value, except on the control that it comes from.
   * @param {number} value
   * @param {HTMLInputElement} [source]
   */
  show(value, source) {
    this.#value = value;
    const place = this.#place(value);
    if (source !== this.#number) this.#number.value = String(tidy(value));
    if (source !== this.#slider) this.#slider.value = String(place);
    const [min, max] = [Number(this.#slider.min), Number(this.#slider.max)];
    this.#slider.style.setProperty("--part", `${(100 * (place - min)) / (max - min)}%`);
    this.#slider.setAttribute("aria-valuetext", `${tidy(value)}${this.#unit}`);
  }

  /** @param {number} value */
  #place(value) {
    return this.#isLogarithmic ? Math.log10(value) : value;
  }

  /**
   * The value at a place, rounded to four significant digits and within the ends.
   * @param {number} place
   */
  #ofPlace(place) {
    const [least, most] = this.#ends;
    const value = Number((this.#isLogarithmic ? 10 ** place : place).toPrecision(4));
    return Math.min(Math.max(value, least), most);
  }
}
