// The scenes to choose from, each with a small picture of it.
import { Stage } from "./pkg/wasm_demo.js";
import { copyOf, element, find } from "./elements.js";
import { thumbnail } from "./share.js";
import { hire } from "./workers.js";

export class ScenePicker {
  #scenes = new Map(Stage.examples().map((scene) => [scene.name, scene]));
  #holder = element("scenes");
  /** @type {import("./pkg/wasm_demo.js").ExampleState | undefined} */
  #shown;

  /** Called with the name of a scene that the visitor chooses. */
  onchange = /** @type {(scene: string) => void} */ (() => {});

  constructor() {
    for (const { name, title } of this.#scenes.values()) {
      const item = copyOf("scene");
      const input = find(item, "input", HTMLInputElement);
      input.id = `scene-${name}`;
      input.value = name;
      find(item, "span").textContent = title;
      input.addEventListener("input", () => this.onchange(name));
      this.#holder.append(item);
    }
  }

  /**
   * Marks a scene.
   * @param {string} name
   */
  show(name) {
    const chosen = element(`scene-${name}`, HTMLInputElement);
    chosen.checked = true;
    // The list is a row, which scrolls where it is too wide.
    const { offsetLeft, offsetWidth } = /** @type {HTMLElement} */ (chosen.parentElement);
    if (this.#shown !== this.#scenes.get(name)) this.#holder.scrollLeft = offsetLeft - (this.#holder.clientWidth - offsetWidth) / 2;
    this.#shown = this.#scenes.get(name);
  }

  /**
   * Draws the small pictures, one at a time, in a worker if the browser has one.
   * @param {WebAssembly.Module} module
   */
  async draw(module) {
    const [helper] = hire(1);
    for (const item of this.#holder.querySelectorAll("label")) {
      const canvas = find(item, "canvas", HTMLCanvasElement);
      // One pixel of the picture is one of the device.
      const width = Math.round(canvas.clientWidth * devicePixelRatio) || canvas.width;
      const height = Math.round((width * canvas.height) / canvas.width);
      const order = { scene: find(item, "input", HTMLInputElement).value, width, height };
      const pixels = await (helper?.ask("thumbnail", { module, ...order }).catch(() => drawHere(order)) ?? drawHere(order));
      Object.assign(canvas, { width, height });
      canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
    }
    helper?.end();
  }

  get title() {
    return this.#shown?.title ?? "";
  }

  /** One sentence about the effects that the scene needs. */
  get summary() {
    return this.#shown?.summary ?? "";
  }
}

/**
 * Draws a small picture on the page, which may have something else to do before.
 * @param {{ scene: string, width: number, height: number }} order
 */
async function drawHere(order) {
  await new Promise((resolve) => setTimeout(resolve, 30));
  return thumbnail(order);
}
