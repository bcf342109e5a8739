// The drawer with the code of the selected light. What writes it is loaded when the drawer is opened.
import { element, find } from "./elements.js";
import { words } from "./failure.js";
import { built } from "./parts.js";
import { load } from "./support.js";

export class CodeSlot {
  #place = element("code", HTMLDetailsElement);
  /** @type {Promise<import("./code-drawer.js").CodeDrawer> | undefined} */
  #opening;
  /** @type {import("./code-drawer.js").CodeDrawer | undefined} */
  #drawer;
  #light = { job: "", light: 0 };

  constructor() {
    this.#place.addEventListener("toggle", () => this.#open());
  }

  /**
   * Shows the code of a light.
   * @param {{ job: string, light: number }} light a job of the stage, and the number of the light in it
   */
  show(light) {
    this.#light = light;
    if (this.#place.open) this.#drawer?.show(light);
  }

  /** Shows the drawer. It is loaded again after a failure when it is opened again. */
  async #open() {
    if (!this.#place.open) return;
    this.#opening ??= this.#load().catch((error) => {
      this.#opening = undefined;
      throw error;
    });
    try {
      this.#drawer = await this.#opening;
      this.#drawer.show(this.#light);
    } catch (error) {
      element("code-told").textContent = "";
      find(this.#place, ".error").textContent = `The code can't be shown: ${words(error)}`;
    }
  }

  /** @returns {Promise<import("./code-drawer.js").CodeDrawer>} */
  async #load() {
    find(this.#place, ".error").textContent = "";
    await built("code", (text) => {
      element("code-told").textContent = text;
      for (const id of ["code-text", "code-copy"]) element(id).hidden = true;
    });
    return (await load("code-drawer.js")).CodeDrawer.open();
  }
}
