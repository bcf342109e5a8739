// The scenes to choose from, each with a small picture of it.
import { Stage } from "./pkg/wasm_demo.js";
import { aside } from "./failure.js";
import { plain } from "./plain.js";

export class ScenePicker {
  #scenes = new Map(Stage.examples().map((scene) => [scene.name, plain(scene)]));
  #holder = document.getElementById("scenes");
  #shown;
  #isDrawn = false;

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

  /** Marks a scene. The small pictures are drawn after the first large one. */
  show(name) {
    this.#shown = this.#scenes.get(name);
    document.getElementById(`scene-${name}`).checked = true;
    if (!this.#isDrawn) setTimeout(() => this.#draw([...this.#holder.querySelectorAll("label")]), 500);
    this.#isDrawn = true;
  }

  get title() {
    return this.#shown.title;
  }

  /** One sentence about the effects that the scene needs. */
  get summary() {
    return this.#shown.summary;
  }

  /** Draws one picture at a time and yields to the browser between them. */
  #draw([item, ...rest]) {
    if (!item) return;
    aside(() => {
      const canvas = item.querySelector("canvas");
      const { width, height } = canvas;
      const pixels = Stage.thumbnail(item.querySelector("input").value, width, height);
      canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);
    });
    setTimeout(() => this.#draw(rest), 30);
  }
}
