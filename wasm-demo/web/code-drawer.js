// The selected light as source of other languages, by the library's own exporter.
import { Code, initSync } from "./pkg/code.js";
import { copyTextOf } from "./clipboard.js";
import { element as find } from "./elements.js";
import { refusalOf } from "./failure.js";
import { compile } from "./module.js";

/** @param {string} id */
const element = (id) => find(`code-${id}`);

/** Loads the exporter. */
export async function openCode() {
  initSync({ module: await compile(new URL("pkg/code_bg.wasm", import.meta.url)) });
  return new Code();
}

export class CodeDrawer {
  #code;
  #language = find("code-language", HTMLSelectElement);
  #light = { job: "", light: 0 };

  /** Loads the exporter. */
  static async open() {
    return new CodeDrawer(await openCode());
  }

  /** @param {Code} code */
  constructor(code) {
    this.#code = code;
    this.#language.addEventListener("input", () => this.show(this.#light));
    element("copy").addEventListener("click", () => copyTextOf(element("text"), element("told")));
  }

  /**
   * Shows the code of a light in the chosen language, or why there is none.
   * @param {{ job: string, light: number }} light a job of the stage, and the number of the light in it
   */
  show(light) {
    this.#light = light;
    let code = "";
    const refusal = refusalOf(() => (code = this.#code.write(light.job, light.light, this.#language.value)));
    element("error").textContent = refusal;
    element("told").textContent = "";
    element("text").textContent = code;
    for (const id of ["text", "copy"]) element(id).hidden = refusal !== "";
  }
}
