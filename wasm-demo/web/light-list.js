// The lights of the scene: each can be selected and switched.
import { plain } from "./plain.js";

export class LightList {
  #stage;
  #list = document.getElementById("lights");
  #count = document.getElementById("lights-count");

  /** The number of the selected light. */
  selected = 0;
  /** Called with a change of the state. */
  onchange = () => {};
  /** Called when the visitor selects a light. */
  onselect = () => {};

  constructor(stage) {
    this.#stage = stage;
    for (const [id, on] of [["all-on", true], ["all-off", false]]) {
      document.getElementById(id).addEventListener("click", () => this.onchange(() => this.#switchAll(on)));
    }
  }

  /** Shows the lights. */
  show() {
    const lights = this.#stage.lights().map(plain);
    this.selected = Math.max(0, Math.min(this.selected, lights.length - 1));
    while (this.#list.children.length > lights.length) this.#list.lastElementChild.remove();
    while (this.#list.children.length < lights.length) this.#list.append(this.#item(this.#list.children.length));
    for (const [light, state] of lights.entries()) this.#tell(this.#list.children[light], light, state);
    this.#count.textContent = `${lights.filter(({ on }) => on).length} of ${lights.length} on`;
  }

  #item(light) {
    const item = document.getElementById("light").content.firstElementChild.cloneNode(true);
    const [radio, box] = item.querySelectorAll("input");
    radio.id = `light-${light}`;
    box.id = `light-${light}-on`;
    radio.addEventListener("input", () => {
      this.selected = light;
      this.onselect();
    });
    box.addEventListener("input", () => this.onchange(() => this.#stage.setOn(light, box.checked)));
    return item;
  }

  #tell(item, light, { name, color, on }) {
    const [radio, box] = item.querySelectorAll("input");
    radio.checked = light === this.selected;
    box.checked = on;
    box.setAttribute("aria-label", `Light ${light + 1} on`);
    item.classList.toggle("off", !on);
    item.style.setProperty("--light", color);
    item.querySelector(".name").textContent = `${light + 1} ${name}`;
  }

  #switchAll(on) {
    for (let light = 0; light < this.#list.children.length; light += 1) this.#stage.setOn(light, on);
  }
}
