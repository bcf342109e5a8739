// The number format: requested by the visitor, in use once every light fits into it.
import { Demo } from "./pkg/wasm_demo.js";

/** Describes the largest difference between a picture in this format and the reference format. */
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
  /** The requested format; the one in use is the module's `format`. */
  #wanted;

  /** Called when another format is in use. */
  onchange = () => {};

  constructor(demo, desk) {
    this.#demo = demo;
    this.#desk = desk;
    this.#wanted = demo.format;
    this.#select.addEventListener("input", () => this.choose(this.#select.value));
  }

  /** Requests a format. While a light does not fit, the last picture stays in its format. */
  choose(name) {
    // An unknown name is an error of the caller and is not shown on the page.
    Demo.statedError(name);
    this.#wanted = name;
    this.#apply();
  }

  /** Tries again: a light that did not fit may have been widened. */
  retry() {
    if (this.#wanted !== this.#demo.format) this.#apply();
  }

  /** Shows the requested format, and the properties of the one in use. */
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
