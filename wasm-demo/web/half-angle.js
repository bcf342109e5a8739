// The half angle of the beam: a dial with its own message.
import { Dial } from "./dial.js";
import { element } from "./elements.js";

/** Invalid values are refused with a message. */
export class HalfAngle {
  #number = element("half-angle-number", HTMLInputElement);
  #error = element("half-angle-error");
  #dial;
  #set;
  /** The current value. */
  #value = NaN;

  /**
   * @param {[number, number]} ends the narrowest and the widest, in degrees
   * @param {(degrees: number) => void} set called on a change, NaN for no number; may throw
   */
  constructor(ends, set) {
    this.#set = set;
    /** @type {(value: number, source: HTMLInputElement) => void} */
    const take = (value, source) => this.take(value, source);
    /** @type {(_: HTMLInputElement, source: HTMLInputElement | undefined, isSet: boolean) => void} */
    const leave = (_, source, isSet) => {
      if (!isSet) this.#tell("");
      this.show(this.#value, source);
    };
    this.#dial = new Dial(element("half-angle", HTMLInputElement), this.#number, take, leave, "°");
    this.#dial.range(...ends);
  }

  /**
   * Shows a value, except on the control that it comes from.
   * @param {number} value
   * @param {Element} [source]
   */
  show(value, source) {
    this.#value = value;
    this.#dial.show(value, source);
  }

  /**
   * Sets a half angle in degrees. A refusal is shown and changes nothing else.
   * @param {number} value
   * @param {Element} [source]
   */
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

  /** @param {string} refusal */
  #tell(refusal) {
    this.#error.textContent = refusal;
    this.#number.setAttribute("aria-invalid", String(refusal !== ""));
  }
}
