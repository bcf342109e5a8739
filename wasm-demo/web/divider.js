// The divider between left and right: one position for all split pictures.

/**
 * Each is a slider over its picture, so that it can be dragged, pressed anywhere, and moved by
 * keys. The place is the style property --split of the element that holds them all.
 */
export class Divider {
  #sliders;
  #holder;

  constructor(holder) {
    this.#holder = holder;
    this.#sliders = [...holder.querySelectorAll(".divider")];
    for (const slider of this.#sliders) slider.addEventListener("input", () => this.#move(slider.value));
    this.#move(50);
  }

  #move(percent) {
    for (const slider of this.#sliders) {
      slider.value = percent;
      slider.setAttribute("aria-valuetext", `A on ${Math.round(percent)} % of the picture`);
    }
    this.#holder.style.setProperty("--split", `${percent}%`);
  }
}
