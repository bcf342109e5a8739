// The scenes to choose from, each with a small picture of it.
import { Stage } from "./pkg/wasm_demo.js";
import { plain } from "./plain.js";
import { thumbnail } from "./share.js";
import { hire } from "./workers.js";

export class ScenePicker {
  #scenes = new Map(Stage.examples().map((scene) => [scene.name, plain(scene)]));
  #holder = document.getElementById("scenes");
  #shown;

  /** Called with the name of a scene that the visitor chooses. */
  onchange = () => {};

  constructor() {
    for (const { name, title } of this.#scenes.values()) {
      const item = document.getElementById("scene").content.firstElementChild.cloneNode(true);
      const input = item.querySelector("input");
      input.id = `scene-${name}`;
      input.value = name;
      item.querySelector("span").textContent = title;
      input.addEventListener("input", () => this.onchange(name));
      this.#holder.append(item);
    }
  }

  /** Marks a scene. */
  show(name) {
    this.#shown = this.#scenes.get(name);
    document.getElementById(`scene-${name}`).checked = true;
  }

  /** Draws the small pictures, one at a time, in a worker if the browser has one. */
  async draw(module) {
    const [helper] = hire(1);
    for (const item of this.#holder.querySelectorAll("label")) {
      const canvas = item.querySelector("canvas");
      // One pixel of the picture is one of the device.
      const width = Math.round(canvas.clientWidth * devicePixelRatio) || canvas.width;
      const height = Math.round((width * canvas.height) / canvas.width);
      const order = { scene: item.querySelector("input").value, width, height };
      const pixels = await (helper?.ask("thumbnail", { module, ...order }).catch(() => drawHere(order)) ?? drawHere(order));
      Object.assign(canvas, { width, height });
      canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);
    }
    helper?.end();
  }

  get title() {
    return this.#shown.title;
  }

  /** One sentence about the effects that the scene needs. */
  get summary() {
    return this.#shown.summary;
  }
}

/** Draws a small picture on the page, which may have something else to do before. */
async function drawHere(order) {
  await new Promise((resolve) => setTimeout(resolve, 30));
  return thumbnail(order);
}
