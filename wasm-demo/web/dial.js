// A slider, logarithmic or linear, and a number beside it, for one value.
import { showPart } from "./elements.js";
import { tidy } from "./numbers.js";

/**
 * Connects a number field: `set` gets what was typed when the field is left or Enter pressed, because
 * the 1 of 12 would be a value, too. `leave` is called when there is nothing to set.
 * @param {HTMLInputElement} field
 * @param {(value: number, field: HTMLInputElement) => void} set
 * @param {(field: HTMLInputElement | undefined, isSet: boolean) => void} leave with the field if it is
 *   empty, and whether it has just set a value, whose refusal nobody has read yet
 */
export function joinNumber(field, set, leave) {
  let isSet = false;
  // The browser returns NaN for invalid text. An empty field is about to be filled.
  const isEmpty = () => field.value === "" && !field.validity.badInput;
  field.addEventListener("input", () => isEmpty() && leave(field, false));
  field.addEventListener("change", () => {
    if (isEmpty()) return;
    isSet = true;
    // A field that is left sets its value in the task in which it loses the focus.
    setTimeout(() => (isSet = false));
    set(field.valueAsNumber, field);
  });
  field.addEventListener("blur", () => leave(undefined, isSet));
}

/**
 * Rounds to four significant digits; the slider would give a dozen.
 * @param {number} value
 */
const round = (value) => Number(value.toPrecision(4));

/**
 * The slider covers the valid or the usual range. The number field accepts any text, so that the kernel can
 * explain what is wrong with a value.
 */
export class Dial {
  #slider;
  #number;
  #unit = "";
  #ends = /** @type {[number, number]} */ ([1, 1]);
  #isLogarithmic = true;
  #isWhole = false;
  /** The value that is shown. */
  #value = NaN;

  /**
   * @param {HTMLInputElement} slider
   * @param {HTMLInputElement} number
   * @param {(value: number, control: HTMLInputElement) => void} set called on a change, NaN for no number
   * @param {(number: HTMLInputElement, source: HTMLInputElement | undefined, isSet: boolean) => void} leave
   *   called when the number is empty, with itself as the source, and when it loses focus: then the
   *   value is shown again, and its refusal ends unless it has just been set
   */
  constructor(slider, number, set, leave) {
    this.#slider = slider;
    this.#number = number;
    slider.addEventListener("input", () => set(this.#ofSlider(), slider));
    joinNumber(number, set, (source, isSet) => {
      leave(number, source, isSet);
      this.show(this.#value, source);
    });
  }

  /**
   * Sets the ends of the slider; those of a logarithmic one are more than 0.
   * @param {number} least
   * @param {number} most
   * @param {string} unit for people who hear the value of the slider
   * @param {boolean} [isLogarithmic]
   * @param {boolean} [isWhole]
   */
  range(least, most, unit, isLogarithmic = true, isWhole = false) {
    this.#ends = [least, most];
    this.#unit = unit;
    this.#isLogarithmic = isLogarithmic;
    this.#isWhole = isWhole;
    [this.#slider.min, this.#slider.max] = this.#ends.map((end) => String(this.#place(end)));
  }

  /**
   * Shows a value, except on the control that it comes from: nobody wants his text rewritten while
   * he types.
   * @param {number} value NaN for none: the number is empty, and the slider in its middle
   * @param {Element} [source]
   */
  show(value, source) {
    this.#value = value;
    const text = Number.isNaN(value) ? "" : String(tidy(value));
    if (source !== this.#number) this.#number.value = text;
    if (source !== this.#slider) this.#slider.value = String(this.#place(this.#within(value)));
    showPart(this.#slider);
    this.#slider.setAttribute("aria-valuetext", text === "" ? "not set" : text + this.#unit);
  }

  /** @param {number} value */
  #place(value) {
    return this.#isLogarithmic ? Math.log10(value) : value;
  }

  /** @param {number} value */
  #within(value) {
    const [least, most] = this.#ends;
    return Math.min(Math.max(value, least), most);
  }

  /** The rounded value of the slider, within its ends. */
  #ofSlider() {
    const place = this.#slider.valueAsNumber;
    const value = this.#isLogarithmic ? 10 ** place : place;
    return this.#within(this.#isWhole ? Math.round(value) : round(value));
  }
}
