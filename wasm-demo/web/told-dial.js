// A dial with a message of its own, for what is wrong with its value.
import { Dial } from "./dial.js";
import { element } from "./elements.js";
import { refusalOf } from "./failure.js";

export class ToldDial {
  #number;
  #error;
  #dial;
  #set;

  /**
   * @param {{ slider: string, number: string, error: string }} ids of its parts
   * @param {(value: number) => void} set called on a change, NaN for no number; may throw a refusal
   */
  constructor({ slider, number, error }, set) {
    this.#number = element(number, HTMLInputElement);
    this.#error = element(error);
    this.#set = set;
    /** @type {(value: number, source: HTMLInputElement) => void} */
    const take = (value, source) => this.take(value, source);
    this.#dial = new Dial(element(slider, HTMLInputElement), this.#number, take, (_, source, isSet) => isSet || this.tell(""));
  }

  /** @param {Parameters<Dial["range"]>} range */
  range(...range) {
    this.#dial.range(...range);
  }

  /**
   * Shows a value, except on the control that it comes from.
   * @param {number} value
   * @param {Element} [source]
   */
  show(value, source) {
    this.#dial.show(value, source);
  }

  /**
   * Sets a value. A refusal is shown and changes nothing else.
   * @param {number} value
   * @param {Element} [source]
   */
  take(value, source) {
    const refusal = refusalOf(() => this.#set(value));
    this.tell(refusal);
    if (refusal === "") this.show(value, source);
  }

  /** @param {string} refusal */
  tell(refusal) {
    this.#error.textContent = refusal;
    this.#number.setAttribute("aria-invalid", String(refusal !== ""));
  }
}
