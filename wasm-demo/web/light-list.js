// The lights of a scene with their switches.
import { plain } from "./plain.js";

export class LightList {
  #scenes;
  #list = document.getElementById("scene-lights");
  #count = document.getElementById("scene-lights-count");

  /** Called when a light was switched. */
  onchange = () => {};

  constructor(scenes) {
    this.#scenes = scenes;
    for (const [id, on] of [["scene-all-on", true], ["scene-all-off", false]]) {
      document.getElementById(id).addEventListener("click", () => this.#switchAll(on));
    }
  }

  /** Shows the lights of the scene that was opened. */
  open() {
    this.#list.replaceChildren(...this.#scenes.lights().map((state, light) => this.#item(plain(state), light)));
    this.#tell();
  }

  #item({ name, color, on }, light) {
    const holder = document.getElementById("light").content.firstElementChild.cloneNode(true);
    const input = holder.querySelector("input");
    input.id = `scene-light-${light}`;
    input.checked = on;
    holder.style.setProperty("--light", color);
    holder.querySelector(".name").textContent = `${light + 1} ${name}`;
    input.addEventListener("input", () => {
      this.#scenes.setOn(light, input.checked);
      this.#tell();
      this.onchange();
    });
    return holder;
  }

  #switchAll(on) {
    for (const [light, input] of this.#inputs.entries()) {
      input.checked = on;
      this.#scenes.setOn(light, on);
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
