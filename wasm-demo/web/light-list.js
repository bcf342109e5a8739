// The lights of the scene: each can be selected and switched.
import { copyOf, element, find } from "./elements.js";
import { plain } from "./plain.js";

/** @typedef {import("./pkg/wasm_demo.js").Stage} Stage */
/** @typedef {import("./plain.js").Plain<import("./pkg/wasm_demo.js").LightState>} Light */

export class LightList {
  #stage;
  #list = element("lights");
  #count = element("lights-count");

  /** The number of the selected light. */
  selected = 0;
  /** Called with a change of the state. */
  onchange = /** @type {(act: () => void) => void} */ (() => {});
  /** Called when the visitor selects a light. */
  onselect = () => {};

  /** @param {Stage} stage */
  constructor(stage) {
    this.#stage = stage;
    element("light-add").addEventListener("click", () => this.onchange(() => this.#add()));
    for (const { id, on } of [{ id: "all-on", on: true }, { id: "all-off", on: false }]) {
      element(id).addEventListener("click", () => this.onchange(() => this.#switchAll(on)));
    }
  }

  /** Shows the lights. */
  show() {
    const lights = this.#stage.lights().map(plain);
    this.selected = Math.max(0, Math.min(this.selected, lights.length - 1));
    while (this.#list.children.length > lights.length) this.#list.lastElementChild?.remove();
    while (this.#list.children.length < lights.length) this.#list.append(this.#item(this.#list.children.length));
    for (const [light, item] of [...this.#list.children].entries()) {
      this.#tell(/** @type {HTMLElement} */ (item), light, /** @type {Light} */ (lights[light]));
    }
    this.#count.textContent = `${lights.filter(({ on }) => on).length} of ${lights.length} on`;
  }

  /** @param {number} light */
  #item(light) {
    const item = copyOf("light");
    const { radio, box } = inputs(item);
    radio.id = `light-${light}`;
    box.id = `light-${light}-on`;
    radio.addEventListener("input", () => {
      this.selected = light;
      this.onselect();
    });
    box.addEventListener("input", () => this.onchange(() => this.#stage.setOn(light, box.checked)));
    return item;
  }

  /**
   * @param {HTMLElement} item
   * @param {number} light
   * @param {Light} state
   */
  #tell(item, light, { name, color, on }) {
    const { radio, box } = inputs(item);
    radio.checked = light === this.selected;
    box.checked = on;
    box.setAttribute("aria-label", `Light ${light + 1} on`);
    item.classList.toggle("off", !on);
    item.style.setProperty("--light", color);
    const title = find(item, ".name");
    title.textContent = title.title = `${light + 1} ${name}`;
  }

  /** Adds a light and selects it. */
  #add() {
    this.#stage.addLight();
    this.selected = this.#stage.lightCount - 1;
  }

  /** @param {boolean} on */
  #switchAll(on) {
    for (let light = 0; light < this.#list.children.length; light += 1) this.#stage.setOn(light, on);
  }
}

/**
 * The choice of a light and its switch.
 * @param {HTMLElement} item
 */
const inputs = (item) => ({
  radio: find(item, "[type=radio]", HTMLInputElement),
  box: find(item, "[type=checkbox]", HTMLInputElement),
});
