// The half angle of the beam: a dial with its own message.
import { Dial } from "./dial.js";

const element = (name) => document.getElementById(`half-angle${name}`);

/** Invalid values are refused with a message. */
export class HalfAngle {
  #number = element("-number");
  #error = element("-error");
  #dial;
  #set;
  /** The current value. */
  #value;

  /**
   * @param {[number, number]} ends the narrowest and the widest, in degrees
   * @param {(degrees: number) => void} set called on a change, NaN for no number; may throw
   */
  constructor(ends, set) {
    this.#set = set;
    const take = (value, source) => this.take(value, source);
    const leave = (_, source) => {
      this.#tell("");
      this.show(this.#value, source);
    };
    this.#dial = new Dial(element(""), this.#number, take, leave, "°");
    this.#dial.range(...ends);
  }

  /** Shows a value, except on the control that it comes from. */
  show(value, source) {
    this.#value = value;
    this.#dial.show(value, source);
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
}
