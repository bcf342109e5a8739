// The lamps of a scene with their switches.
import { plain } from "./plain.js";

export class LampList {
  #scenes;
  #list = document.getElementById("scene-lamps");
  #count = document.getElementById("scene-lamps-count");

  /** Called when a lamp was switched. */
  onchange = () => {};

  constructor(scenes) {
    this.#scenes = scenes;
    for (const [id, on] of [["scene-all-on", true], ["scene-all-off", false]]) {
      document.getElementById(id).addEventListener("click", () => this.#switchAll(on));
    }
  }

  /** Shows the lamps of the scene that was opened. */
  open() {
    this.#list.replaceChildren(...this.#scenes.lamps().map((state, lamp) => this.#item(plain(state), lamp)));
    this.#tell();
  }

  #item({ name, color, on }, lamp) {
    const holder = document.getElementById("lamp").content.firstElementChild.cloneNode(true);
    const input = holder.querySelector("input");
    input.id = `scene-lamp-${lamp}`;
    input.checked = on;
    holder.style.setProperty("--lamp", color);
    holder.querySelector(".name").textContent = `${lamp + 1} ${name}`;
    input.addEventListener("input", () => {
      this.#scenes.setOn(lamp, input.checked);
      this.#tell();
      this.onchange();
    });
    return holder;
  }

  #switchAll(on) {
    for (const [lamp, input] of this.#inputs.entries()) {
      input.checked = on;
      this.#scenes.setOn(lamp, on);
    }
    this.#tell();
    this.onchange();
  }

  get #inputs() {
    return [...this.#list.querySelectorAll("input")];
  }

  #tell() {
    const inputs = this.#inputs;
    const lit = inputs.filter((input) => input.checked).length;
    this.#count.textContent = `${lit} of ${inputs.length} on`;
    for (const input of inputs) input.closest("li").classList.toggle("off", !input.checked);
  }
}
