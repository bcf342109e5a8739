// What a program needs to draw the light that is selected on the stage.
import { copyTextOf } from "./clipboard.js";
import { openCode } from "./code-drawer.js";
import { element as find, fetchText } from "./elements.js";
import { refusalOf } from "./failure.js";
import { built } from "./parts.js";

/** @typedef {{ job: string, light: number, name: string }} Selected a light of a job of the stage */

/** @param {string} id */
const element = (id) => find(`use-${id}`);

/** The files for download, by their links, and their names as languages of the exporter. */
const FILES = { script: "rust-build", header: "luminaire.h", constants: "luminaire_constant.h", constant: "c-fx16" };

export class UseView {
  #code;
  #selected;

  /**
   * Loads the view and the exporter.
   * @param {() => Selected | undefined} selected what is selected on the stage
   */
  static async open(selected) {
    const [code, text] = await Promise.all([openCode(), fetchText("use.html")]);
    find("use").innerHTML = text;
    return new UseView(code, selected);
  }

  /**
   * @param {import("./pkg/code.js").Code} code
   * @param {() => Selected | undefined} selected
   */
  constructor(code, selected) {
    this.#code = code;
    this.#selected = selected;
    // With a slash at its end, if the page was built for one.
    const source = document.querySelector("meta[name=repository]")?.getAttribute("content");
    element("dependency").textContent = `[dependencies]\nluminaire = { ${source ? `git = "${source.slice(0, -1)}"` : 'path = "luminaire/core"'} }`;
    element("place").hidden = Boolean(source);
    element("links").hidden = !source;
    find("use-source", HTMLAnchorElement).href = source ?? "";
    find("use-guide", HTMLAnchorElement).href = `${source}blob/HEAD/core/src/guide.rs`;
    // Without the chip there is no firmware to offer, and its own view says why.
    built("chip").then(() => (element("firmware").hidden = false), () => {});
    for (const button of /** @type {NodeListOf<HTMLElement>} */ (find("use").querySelectorAll("[data-copies]"))) {
      button.addEventListener("click", () => copyTextOf(find(button.dataset.copies ?? ""), element("told")));
    }
  }

  /** Called when the view is shown: another light may be selected. */
  show() {
    const selected = this.#selected();
    element("light").textContent = selected?.name ?? "none";
    /** @type {(language: string) => { text: string, refusal: string }} */
    const write = (language) => {
      let text = "";
      const refusal = refusalOf(() => (text = this.#code.write(selected?.job ?? "", selected?.light ?? 0, language)));
      return { text, refusal };
    };
    const { text, refusal } = write("rust-program");
    element("code").textContent = text;
    element("error").textContent = refusal;
    element("told").textContent = "";
    for (const [id, language] of Object.entries(FILES)) {
      const [link, { text, refusal }] = [find(`use-${id}`, HTMLAnchorElement), write(language)];
      URL.revokeObjectURL(link.href);
      link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
      /** @type {HTMLElement} */ (link.parentElement).hidden = refusal !== "";
    }
  }

  hide() {}
}
