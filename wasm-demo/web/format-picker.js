// The number format: asked for, and taken once every light fits into it.
import { Demo } from "./pkg/wasm_demo.js";

/** How near a picture in this format comes to the one that the others are compared with. */
export function accuracy(format) {
  const error = Demo.statedError(format);
  return error === 0 ? "what the other formats are compared with" : `within ${error} of 255 display codes of f32`;
}

export class FormatPicker {
  #demo;
  #desk;
  #select = document.getElementById("format");
  #note = document.getElementById("format-note");
  #error = document.getElementById("format-error");
  /** What the visitor asked for; what is in force is the module's `format`. */
  #wanted;

  /** Called when another format is in force. */
  onchange = () => {};

  constructor(demo, desk) {
    this.#demo = demo;
    this.#desk = desk;
    this.#wanted = demo.format;
    this.#select.addEventListener("input", () => this.choose(this.#select.value));
  }

  /** Asks for a format. While a light does not fit, the last picture stays, in the format that it has. */
  choose(name) {
    // An unknown name is a caller's mistake, which has no place on the page.
    Demo.statedError(name);
    this.#wanted = name;
    this.#apply();
  }

  /** Tries again: a light that did not fit may have been widened. */
  retry() {
    if (this.#wanted !== this.#demo.format) this.#apply();
  }

  /** Shows the format that was asked for, and of the one in force what there is to know. */
  show() {
    this.#select.value = this.#wanted;
    const { format } = this.#demo;
    this.#note.textContent =
      format === this.#wanted
        ? accuracy(format)
        : `still in ${this.#select.querySelector(`[value="${format}"]`).textContent}`;
  }

  #apply() {
    const before = this.#demo.format;
    let refusal = "";
    try {
      this.#demo.setFormat(this.#wanted);
    } catch (error) {
      if (typeof error !== "string") throw error;
      refusal = error;
    }
    this.#tell(refusal);
    this.show();
    if (this.#demo.format !== before) this.onchange();
  }

  #tell(refusal) {
    this.#error.textContent = refusal;
    this.#select.setAttribute("aria-invalid", refusal !== "");
    for (let light = 0; light < this.#demo.lights; light += 1) {
      this.#desk.object(light, (refusal && this.#demo.objection(this.#wanted, light)) ?? "");
    }
  }
}
