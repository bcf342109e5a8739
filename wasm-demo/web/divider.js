// The divider between left and right: one position for all split pictures.

/**
 * Each is a slider over its picture, so that it can be dragged, pressed anywhere, and moved by
 * keys. The place is the style property --split of the element that holds them all.
 */
export class Divider {
  #sliders;
  #holder;

  /**
   * What is on the left, to those who listen.
   * @type {string}
   */
  left = "A";

  /** Called when the visitor moves it. */
  oninput = () => {};

  /** @param {HTMLElement} holder */
  constructor(holder) {
    this.#holder = holder;
    this.#sliders = /** @type {HTMLInputElement[]} */ ([...holder.querySelectorAll(".divider")]);
    for (const slider of this.#sliders) {
      slider.addEventListener("input", () => {
        this.oninput();
        this.move(slider.valueAsNumber);
      });
    }
    this.move(50);
  }

  /** @param {number} percent */
  move(percent) {
    for (const slider of this.#sliders) {
      slider.valueAsNumber = percent;
      slider.setAttribute("aria-valuetext", `${this.left} on ${Math.round(percent)} % of the picture`);
    }
    this.#holder.style.setProperty("--split", `${percent}%`);
  }
}
