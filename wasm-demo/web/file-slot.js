// The place of the lights of a file, which a button opens, or which is dropped anywhere on the page. What reads
// it is loaded with the first file.
import { element } from "./elements.js";
import { words } from "./failure.js";
import { load } from "./support.js";

/** The most bytes of a file. The readers accept less; a larger file is not even loaded. */
const MOST = 2 ** 26;

export class FileSlot {
  #place = element("file");
  #told = element("file-told");
  #error = element("file-error");
  #stage;
  /** @type {import("./file-panel.js").FilePanel | undefined} */
  #panel;

  /** @param {import("./file-panel.js").OnStage} stage */
  constructor(stage) {
    this.#stage = stage;
    const input = element("file-input", HTMLInputElement);
    element("file-pick").addEventListener("click", () => input.click());
    input.addEventListener("change", () => this.#open(input.files?.[0]));
    for (const name of /** @type {const} */ (["dragover", "dragleave", "drop"])) {
      document.addEventListener(name, (event) => this.#drag(event));
    }
  }

  /** @param {DragEvent} event */
  #drag(event) {
    const { dataTransfer, type, relatedTarget } = event;
    if (!dataTransfer?.types.includes("Files")) return;
    // Else the browser would show the file in place of the page.
    event.preventDefault();
    document.body.classList.toggle("dropping", type === "dragover" || (type === "dragleave" && relatedTarget !== null));
    if (type === "drop") this.#open(dataTransfer.files[0]);
  }

  /** @param {File | undefined} file */
  async #open(file) {
    if (!file) return;
    if (element("stage-page").hidden) location.hash = "stage";
    this.#error.textContent = "";
    this.#told.textContent = `Reading ${file.name}.`;
    try {
      if (file.size > MOST) throw `size = ${file.size}: expected at most ${MOST} bytes`;
      const [bytes, { FilePanel }] = await Promise.all([file.arrayBuffer(), load("file-panel.js")]);
      this.#panel ??= await FilePanel.open(this.#place, this.#stage);
      this.#told.textContent = this.#panel?.show(file.name, new Uint8Array(bytes)) ?? "";
    } catch (error) {
      this.#place.hidden = true;
      this.#told.textContent = "";
      this.#error.textContent = `${file.name}: ${words(error)}`;
    }
    this.#error.scrollIntoView({ block: "nearest" });
  }
}
