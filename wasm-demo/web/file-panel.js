// A light of a file: its curve, its photometry, and its parameters in other tools.
import { LightFile, initSync } from "./pkg/files.js";
import { copyTextOf } from "./clipboard.js";
import { BOX, height, levels } from "./curve.js";
import { element as find } from "./elements.js";
import { refusalOf } from "./failure.js";
import { compile } from "./module.js";
import { counted, degrees } from "./numbers.js";
import { label, line, shape } from "./shapes.js";

/**
 * @typedef {{ name: string, fit: string | null, settings: string | null, intensity: number, isCandela: boolean, beam: number,
 *   field: number, difference: string, photometry: string, points: number[][], drawn: number[][], notes: string[] }} FileLight what the module tells of a light
 */

/**
 * The throw of the selected light of the stage in metres, and what gives it another light and returns the outcome in words.
 * @typedef {{ throwOf: () => number, put: (light: FileLight) => string }} OnStage
 */

/** @param {string} id */
const element = (id) => find(`file-${id}`);
/** @param {string} id */
const select = (id) => find(`file-${id}`, HTMLSelectElement);

export class FilePanel {
  #stage;
  /** @type {LightFile | undefined} */
  #file;
  /** @type {FileLight[]} */
  #lights = [];

  /** @type {(place: HTMLElement, stage: OnStage) => Promise<FilePanel>} loads the panel into its place */
  static async open(place, stage) {
    const [module, answer] = await Promise.all([
      compile(new URL("pkg/files_bg.wasm", import.meta.url)),
      fetch(new URL("file.html", import.meta.url)),
    ]);
    if (!answer.ok) throw new Error(`file.html: the server answers ${answer.status}`);
    initSync({ module });
    place.innerHTML = await answer.text();
    return new FilePanel(stage);
  }

  /** @param {OnStage} stage */
  constructor(stage) {
    this.#stage = stage;
    select("light").addEventListener("input", () => this.#show());
    select("tool").addEventListener("input", () => this.#showParameters());
    element("put").addEventListener("click", () => (element("put-told").textContent = stage.put(this.#lights[select("light").selectedIndex])));
    element("copy").addEventListener("click", async () => (element("copied").textContent = await copyTextOf(element("parameters"))));
  }

  /** @type {(name: string, bytes: Uint8Array) => string} shows a file and returns what it has, or throws a refusal */
  show(name, bytes) {
    this.#file = new LightFile(name, bytes, this.#stage.throwOf());
    const { lights, notes } = JSON.parse(this.#file.told());
    this.#lights = lights;
    element("notes").textContent = notes.join("\n");
    select("light").replaceChildren(...this.#lights.map(({ name }, i) => new Option(`${i + 1} ${name}`, String(i))));
    element("chosen").hidden = lights.length === 0;
    if (lights.length > 0) this.#show();
    return `${name}: ${counted(lights.length, "light")}.`;
  }

  #show() {
    const light = this.#lights[select("light").selectedIndex];
    element("fit").textContent = light.name + (light.fit ? `: ${light.fit}` : "");
    element("difference").textContent = light.difference;
    find("file-curve", SVGElement).replaceChildren(...(light.settings ? curve(light) : []));
    find("file-curve", SVGElement).toggleAttribute("hidden", !light.settings);
    element("photometry").textContent = [light.photometry, ...light.notes].join("\n");
    find("file-put", HTMLButtonElement).disabled = !light.settings;
    element("put-told").textContent = light.settings
      ? "The selected light keeps its place, its aim and its attenuation. A table ends where it is half a code."
      : "Only a spotlight can be put on the stage.";
    this.#showParameters();
  }

  #showParameters() {
    /** @type {string[]} */
    let [text, ...told] = [""];
    const parameters = () => this.#file?.parameters(select("light").selectedIndex, select("tool").value) ?? [""];
    const refusal = refusalOf(() => ([text, ...told] = parameters()));
    element("parameters").textContent = text || refusal;
    element("parameters-told").textContent = told.join("\n");
    element("copied").textContent = "";
  }
}

/** @type {(light: FileLight) => SVGElement[]} draws the shares of the largest intensity over the angle */
function curve({ points, drawn, beam, field }) {
  const end = drawn[drawn.length - 1][0];
  /** @type {(angle: number) => number} */
  const across = (angle) => BOX.left + ((BOX.right - BOX.left) * angle) / end;
  /** @type {(name: string, angle: number, level: number) => SVGElement[]} */
  const mark = (name, angle, level) => {
    const [x, isRight] = [across(angle), across(angle) > 330];
    const text = label(isRight ? "end" : "", isRight ? x - 6 : x + 6, height(level) - 5, `${name} ±${degrees(angle)}`);
    return [line("drop", x, BOX.top, x, BOX.bottom), text];
  };
  return [
    ...levels(),
    ...mark("beam", beam / 2, 0.5),
    ...mark("field", field / 2, 0.1),
    label("end", BOX.right, BOX.bottom + 18, `to ${degrees(end)} off the axis`),
    shape("path", { class: "trace", d: `M${drawn.map(([angle, share]) => [across(angle), height(share)]).join("L")}` }),
    ...points.map(([angle, share]) => shape("circle", { class: "dot", cx: across(angle), cy: height(share), r: 2.5 })),
  ];
}
