// The lights of a file that is picked by a button, or dropped on the page. What reads it is loaded with the first one.
import { element } from "./elements.js";
import { words } from "./failure.js";
import { load } from "./support.js";

export class FileSlot {
  #place = element("file");
  #told = element("file-told");
  #stage;
  /** @type {import("./file-panel.js").FilePanel | undefined} */
  #panel;

  /** @param {import("./file-panel.js").OnStage} stage */
  constructor(stage) {
    this.#stage = stage;
    const input = element("file-input", HTMLInputElement);
    element("file-pick").addEventListener("click", () => input.click());
    input.addEventListener("change", () => this.#open(input.files?.[0]));
    for (const type of /** @type {const} */ (["dragover", "dragleave", "drop"])) {
      document.addEventListener(type, (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        // Else the browser would show the file in place of the page.
        event.preventDefault();
        document.body.classList.toggle("dropping", type === "dragover");
        if (type === "drop") this.#open(event.dataTransfer.files[0]);
      });
    }
  }

  /** @param {File | undefined} file */
  async #open(file) {
    if (!file) return;
    if (element("stage-page").hidden) location.hash = "stage";
    this.#tell(`Reading ${file.name}.`);
    try {
      if (file.size > 2 ** 26) throw `size = ${file.size}: expected at most ${2 ** 26} bytes`;
      const [bytes, { FilePanel }] = await Promise.all([file.arrayBuffer(), load("file-panel.js")]);
      this.#panel ??= await FilePanel.open(this.#place, this.#stage);
      this.#tell(this.#panel?.show(file.name, new Uint8Array(bytes)) ?? "");
      this.#place.hidden = false;
    } catch (error) {
      this.#tell(`${file.name}: ${words(error)}`, "error");
      this.#place.hidden = true;
    }
    this.#told.scrollIntoView({ block: "nearest" });
  }

  #tell(text = "", kind = "note") {
    [this.#told.textContent, this.#told.className] = [text, kind];
  }
}
