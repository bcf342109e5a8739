// A light of a file: its curve, its photometry, and its parameters in other tools.
import { copyTextOf } from "./clipboard.js";
import { BOX, height, levels } from "./curve.js";
import { element as find, fetchText } from "./elements.js";
import { words } from "./failure.js";
import { FileThread } from "./file-thread.js";
import { counted, degrees } from "./numbers.js";
import { label, line, shape } from "./shapes.js";

/**
 * A light, as the module describes it; the LEDs of a map; the throw of the selected light of the stage in metres, and what puts a light or
 * LEDs there and returns the outcome in words.
 * @typedef {{ name: string, fit: string | null, settings: string | null, isCut: boolean, intensity: number, isCandela: boolean, beam: number,
 *   field: number, difference: string, photometry: string, points: number[][], planes: number[][][] | null, drawn: number[][], notes: string[] }} FileLight
 * @typedef {{ places: Float32Array, facing: Float32Array, told: string }} FileLeds
 * @typedef {{ throwOf: () => number, put: (light: FileLight) => string, putLeds: (leds: FileLeds) => string }} OnStage
 */

/** @param {string} id */
const element = (id) => find(`file-${id}`);
/** @param {string} id */
const select = (id) => find(`file-${id}`, HTMLSelectElement);

/**
 * Loads the panel into its place. Returns what shows a file, and returns in words what it has or throws a refusal. Of two files at
 * the same time, only the last one has an answer.
 * @param {HTMLElement} place
 * @param {OnStage} stage
 */
export async function openPanel(place, { throwOf, put, putLeds }) {
  place.innerHTML = await fetchText("file.html");
  const reader = new FileThread();
  /** @type {FileLight[]} */
  let lights = [];
  const light = () => lights[select("light").selectedIndex];

  const showParameters = async () => {
    // Not those of another tool while the search takes its time.
    for (const name of ["parameters", "parameters-told", "copied"]) element(name).textContent = "";
    try {
      const [text, ...told] = await reader.ask({ light: select("light").selectedIndex, tool: select("tool").value });
      element("parameters").textContent = text;
      element("parameters-told").textContent = told.join("\n");
    } catch (refusal) {
      element("parameters").textContent = words(refusal);
    }
  };
  const showPictures = async () => {
    try {
      for (const [name, pixels] of Object.entries(await reader.ask({ light: select("light").selectedIndex }))) {
        const canvas = find(`file-${name}`, HTMLCanvasElement);
        canvas.getContext("2d")?.putImageData(new ImageData(pixels, canvas.width), 0, 0);
      }
    } catch (refusal) {
      element("put-told").textContent = words(refusal);
    }
  };
  const show = () => {
    const { name, fit, settings, isCut, difference, photometry, planes, notes } = light();
    element("fit").textContent = name + (fit ? `: ${fit}` : "");
    element("difference").textContent = difference;
    const drawing = find("file-curve", SVGElement);
    const round = () => (settings ? curve(light()) : []);
    drawing.replaceChildren(...(planes ? polar(planes) : round()));
    drawing.toggleAttribute("hidden", !planes && !settings);
    drawing.setAttribute("aria-label", planes ? "Intensity over the angle, in two planes" : "Intensity over the angle off the axis");
    element("photometry").textContent = [photometry, ...notes].join("\n");
    find("file-put", HTMLButtonElement).disabled = !settings;
    element("uneven").hidden = !planes;
    element("tools").hidden = planes !== null;
    for (const name of ["parameters-told", "copied"]) element(name).textContent = "";
    const end = `half of a code of 255${isCut ? ", and at 80° off its axis, as far as shadows reach" : ""}`;
    let told = "Only a spotlight can be put on the stage.";
    if (planes) told = "The stage draws round lights: of this one, the mean of all its planes.";
    else if (settings) told = `The selected light keeps its place, its aim and its attenuation. A measured light ends where it falls to ${end}.`;
    element("put-told").textContent = told;
    return planes ? showPictures() : showParameters();
  };
  select("light").addEventListener("input", show);
  select("tool").addEventListener("input", showParameters);
  element("put").addEventListener("click", () => (element("put-told").textContent = put(light())));
  element("copy").addEventListener("click", () => copyTextOf(element("parameters"), element("copied")));

  /** @type {(name: string, bytes: Uint8Array<ArrayBuffer>, isRound: boolean) => Promise<{ told: string, isRound: boolean }>} */
  return async (name, bytes, isRound) => {
    const { lights: found, notes, ...leds } = await reader.ask({ name, bytes, reach: throwOf(), isRound });
    lights = found ?? [];
    place.hidden = !found;
    if (!found) return { told: `${name}: ${putLeds(leds)}`, isRound: true };
    element("notes").textContent = notes.join("\n");
    select("light").replaceChildren(...lights.map(({ name }, i) => new Option(`${i + 1} ${name}`, String(i))));
    element("chosen").hidden = lights.length === 0;
    if (lights.length > 0) show();
    return { told: `${name}: ${counted(lights.length, "light")}.`, isRound: lights.every(({ planes }) => !planes) };
  };
}

/**
 * Draws the shares of the largest intensity of two planes about the light, whose axis points down.
 * @type {(planes: number[][][]) => SVGElement[]}
 */
function polar(planes) {
  const [x, y, radius] = [220, 102, 84];
  /** @type {(share: number, angle: number) => [number, number]} */
  const at = (share, angle) => [x + radius * share * Math.sin((angle * Math.PI) / 180), y + radius * share * Math.cos((angle * Math.PI) / 180)];
  return [
    ...[0.5, 1].map((share) => shape("circle", { class: "level", cx: x, cy: y, r: radius * share, fill: "none" })),
    ...[0, 45, 90, 135].map((angle) => line("level", ...at(1, angle), ...at(1, angle + 180))),
    ...[30, 60, 90].map((angle) => label("", at(1, angle)[0] + 6, at(1, angle)[1] + 5, degrees(angle))),
    ...planes.map((plane, i) => shape("path", { class: i ? "other power" : "trace", d: `M${plane.map(([angle, share]) => at(share, angle)).join("L")}Z` })),
    label("", 10, 20, "Side to side: solid line"),
    label("", 10, 38, "Front to back: dashes"),
  ];
}

/** @type {(light: FileLight) => SVGElement[]} draws the shares of the largest intensity over the angle */
function curve({ points, drawn, beam, field }) {
  const end = drawn[drawn.length - 1][0];
  /** @type {(angle: number) => number} */
  const across = (angle) => BOX.left + ((BOX.right - BOX.left) * angle) / end;
  /** @type {(name: string, angle: number, level: number) => SVGElement[]} */
  const mark = (name, angle, level) => {
    const [x, side] = across(angle) > 330 ? [across(angle), -6] : [across(angle), 6];
    return [line("drop", x, BOX.top, x, BOX.bottom), label(side < 0 ? "end" : "", x + side, height(level) - 5, `${name} ±${degrees(angle)}`)];
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
