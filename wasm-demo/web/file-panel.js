// A light of a file: its curve, its photometry, and its parameters in other tools.
import { LightFile, initSync } from "./pkg/files.js";
import { copyTextOf } from "./clipboard.js";
import { element as find } from "./elements.js";
import { refusalOf } from "./failure.js";
import { compile } from "./module.js";
import { amount, counted, degrees, tidy } from "./numbers.js";
import { label, line, shape } from "./shapes.js";

/** @typedef {import("./pkg/files.js").FileLight} FileLight */

/**
 * The throw of the selected light of the stage in metres, and what gives that light the cone, the colour and
 * the intensity of another one, and returns in words what has happened.
 * @typedef {{ throwOf: () => number, put: (light: FileLight) => string }} OnStage
 */

/** @param {string} id */
const element = (id) => find(`file-${id}`);
/** @param {string} id */
const select = (id) => find(`file-${id}`, HTMLSelectElement);

/** The drawing's box, in the units of the SVG's viewBox. */
const BOX = { left: 52, right: 428, top: 24, bottom: 180 };

export class FilePanel {
  #place;
  #stage;
  /** @type {LightFile | undefined} */
  #file;
  /** @type {FileLight[]} */
  #lights = [];

  /**
   * Loads the panel into its place.
   * @param {HTMLElement} place
   * @param {OnStage} stage
   */
  static async open(place, stage) {
    const [module, answer] = await Promise.all([
      compile(new URL("pkg/files_bg.wasm", import.meta.url)),
      fetch(new URL("file.html", import.meta.url)),
    ]);
    if (!answer.ok) throw new Error(`file.html: the server answers ${answer.status}`);
    initSync({ module });
    place.innerHTML = await answer.text();
    return new FilePanel(place, stage);
  }

  /**
   * @param {HTMLElement} place
   * @param {OnStage} stage
   */
  constructor(place, stage) {
    this.#place = place;
    this.#stage = stage;
    select("light").addEventListener("input", () => this.#show());
    select("tool").addEventListener("input", () => this.#showParameters());
    element("close").addEventListener("click", () => (place.hidden = true));
    element("put").addEventListener("click", () => (element("put-note").textContent = stage.put(this.#light)));
    element("copy").addEventListener("click", async () => {
      element("copied").textContent = await copyTextOf(element("parameters"));
    });
  }

  get #light() {
    return this.#lights[select("light").selectedIndex];
  }

  /**
   * Shows a file. Returns in words what it has, and throws what the reader refuses.
   * @param {string} name
   * @param {Uint8Array} bytes
   */
  show(name, bytes) {
    const file = new LightFile(name, bytes, this.#stage.throwOf());
    this.#file?.free();
    this.#file = file;
    this.#lights = file.lights();
    const refused = file.refused();
    element("title").textContent = name;
    element("refused").textContent = refused.join("\n");
    select("light").replaceChildren(...this.#lights.map(({ name }, i) => new Option(`${i + 1} ${name}`, String(i))));
    element("lights").hidden = this.#lights.length < 2;
    element("chosen").hidden = this.#lights.length === 0;
    this.#place.hidden = false;
    if (this.#lights.length > 0) this.#show();
    return `${name}: ${counted(this.#lights.length, "light")}${refused.length > 0 ? `, ${refused.length} refused` : ""}.`;
  }

  #show() {
    const light = this.#light;
    const isSpot = light.cone !== "";
    element("fit").textContent = `${light.name}${light.fit && `: ${light.fit}`}`;
    element("residual").textContent = residual(light);
    find("file-curve", SVGElement).toggleAttribute("hidden", !isSpot);
    find("file-curve", SVGElement).replaceChildren(...(isSpot ? curve(light) : []));
    element("photometry").textContent = photometry(light);
    element("notes").textContent = [...(this.#file?.notes() ?? []), ...light.notes].join("\n");
    find("file-put", HTMLButtonElement).disabled = !isSpot;
    element("put-note").textContent = isSpot
      ? "The selected light keeps its place, its aim and its attenuation."
      : "Only a spotlight can be put on the stage.";
    this.#showParameters();
  }

  #showParameters() {
    /** @type {string[]} */
    let [text, ...told] = [""];
    const number = select("light").selectedIndex;
    const refusal = refusalOf(() => ([text, ...told] = this.#file?.parameters(number, select("tool").value) ?? [""]));
    element("difference").textContent = refusal || told.join("\n");
    element("parameters").textContent = text;
    element("copied").textContent = "";
    for (const id of ["parameters", "copy"]) element(id).hidden = refusal !== "";
  }
}

/**
 * How far the light is from that of the file, in words.
 * @param {FileLight} light
 */
function residual({ fit, residual: [bound, found, at], distance }) {
  if (fit) return `Within ${tidy(bound)} of 255 codes of the measured dots; the largest found is ${tidy(found)} at ${degrees(at)}.`;
  if (bound === 0 && distance === 0) return "Exact.";
  return `Within ${tidy(bound)} of 255 codes over the angle and ${tidy(100 * distance)} % over the distance.`;
}

/** @param {FileLight} light */
function photometry({ intensity, isCandela, lumens, angles: [beam, field], lux, throw: distance }) {
  const [cd, lx] = isCandela ? [" cd", " lx"] : ["", ""];
  const flux = isCandela && lumens !== undefined ? [`${amount(lumens)} lm`] : [];
  const cone = beam === undefined ? [] : [`beam ${degrees(beam)}`, `field ${degrees(field)}`];
  return [`Peak ${amount(intensity)}${cd}`, ...flux, ...cone, `${amount(lux)}${lx} at ${tidy(distance)} m`].join(", ");
}

/**
 * Draws the shares of the largest intensity over the angle.
 * @param {FileLight} light
 */
function curve({ measured, fitted, angles, residual: [, , at, from, to] }) {
  const end = fitted[fitted.length - 2];
  /** @type {(angle: number) => number} */
  const x = (angle) => BOX.left + ((BOX.right - BOX.left) * angle) / end;
  /** @type {(share: number) => number} */
  const y = (share) => BOX.bottom + (BOX.top - BOX.bottom) * share;
  /** @type {(points: Float32Array) => [number, number][]} */
  const pairs = (points) => Array.from({ length: points.length / 2 }, (_, i) => [x(points[2 * i]), y(points[2 * i + 1])]);
  return [
    ...[1, 0.5, 0.1, 0].flatMap((level) => [
      line("level", BOX.left, y(level), BOX.right, y(level)),
      label("end", BOX.left - 8, y(level) + 4, `${100 * level} %`),
    ]),
    // The beam angle is stated above the drawing, and the field angle below it.
    ...[...angles].flatMap((angle, i) => [
      line("drop", x(angle / 2), BOX.top, x(angle / 2), BOX.bottom),
      label("middle", x(angle / 2), i === 0 ? BOX.top - 8 : BOX.bottom + 16, `${i === 0 ? "beam" : "field"} ±${degrees(angle / 2)}`),
    ]),
    label("end", BOX.right, BOX.bottom + 34, `to ${degrees(end)} off the axis`),
    ...pairs(measured).filter(([cx]) => cx <= BOX.right).map(([cx, cy]) => shape("circle", { cx, cy, r: 3 })),
    shape("path", { class: "trace", d: `M${pairs(fitted).join("L")}` }),
    ...(at === undefined ? [] : [line("worst", x(at), y(from), x(at), y(to))]),
  ];
}
