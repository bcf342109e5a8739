// The intensity of a light across its axis, with marks for its angles.
import { degrees } from "./numbers.js";

const SAMPLES = 241;

/** The drawing's box, in the units of the SVG's viewBox. */
const BOX = { left: 52, right: 428, top: 12, bottom: 180 };

/** Vertical positions of intensities. */
const height = (intensity) => BOX.bottom + (BOX.top - BOX.bottom) * intensity;

/** Returns a tick distance of 1, 2 or 5 times a power of ten, for two to five ticks on a side. */
function tickStep(reach) {
  const power = 10 ** Math.floor(Math.log10(reach / 2));
  return power * ([5, 2].find((factor) => reach / (power * factor) >= 2) ?? 1);
}

/** Creates an element of the SVG. */
function shape(name, attributes, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = text;
  return element;
}

const line = (kind, x1, y1, x2, y2) => shape("line", { class: kind, x1, y1, x2, y2 });
const label = (kind, x, y, text) => shape("text", { class: kind, x, y }, text);

export class Curve {
  #stage;
  #svg = document.getElementById("curve");
  #title = document.getElementById("curve-title");
  #format = document.getElementById("curve-format");

  constructor(stage) {
    this.#stage = stage;
  }

  /** Draws the curve of a light, evaluated by the module in the current number format. */
  draw(light) {
    if (light >= this.#stage.lightCount) return;
    const points = this.#stage.curve(light, SAMPLES);
    if (points.length === 0) return;
    const state = this.#stage.light(light);
    const reach = points[points.length - 2];
    const across = (angle) => (BOX.left + BOX.right) / 2 + ((BOX.right - BOX.left) / 2) * (angle / reach);
    this.#svg.style.setProperty("--light", state.color);
    this.#svg.replaceChildren(
      ...levels(),
      ...ticks(reach, across),
      ...trace(points, across),
      ...mark("beam", state.beam, 0.5, across),
      ...mark("field", state.field, 0.1, across),
    );
    this.#title.textContent = `${state.name}: intensity across the axis`;
    this.#format.textContent = `evaluated in ${this.#stage.format}`;
    this.#svg.setAttribute("aria-label", describe(state));
    state.free();
  }
}

const describe = ({ name, beam, field, outer }) =>
  `${name}: half the intensity at ${degrees(beam / 2)} off axis, a tenth at ${degrees(field / 2)}, ` +
  `none from ${degrees(outer / 2)}`;

/** The lines of full, half, tenth and no intensity. */
function levels() {
  return [1, 0.5, 0.1, 0].flatMap((level) => [
    line("level", BOX.left, height(level), BOX.right, height(level)),
    label("percent", BOX.left - 8, height(level) + 4, `${100 * level} %`),
  ]);
}

/** The axis: degrees off the light's axis, to both sides. */
function ticks(reach, across) {
  const step = tickStep(reach);
  const count = Math.floor(reach / step);
  return Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * step).flatMap((angle) => [
    line("tick", across(angle), BOX.bottom, across(angle), BOX.bottom + 4),
    label("degrees", across(angle), BOX.bottom + 19, degrees(angle)),
  ]);
}

/** The curve, and the light under it. */
function trace(points, across) {
  let path = "";
  for (let i = 0; i < points.length; i += 2) {
    path += `${i === 0 ? "M" : "L"}${across(points[i]).toFixed(2)} ${height(points[i + 1]).toFixed(2)}`;
  }
  const ground = `L${BOX.right} ${BOX.bottom}L${BOX.left} ${BOX.bottom}Z`;
  return [shape("path", { class: "glow", d: path + ground }), shape("path", { class: "trace", d: path })];
}

/** Draws a full angle at its intensity level, from one side to the other. */
function mark(name, angle, level, across) {
  const [left, right, y] = [across(-angle / 2), across(angle / 2), height(level)];
  return [
    line("span", left, y, right, y),
    ...[left, right].flatMap((x) => [
      line("drop", x, y, x, BOX.bottom),
      shape("circle", { class: "dot", cx: x, cy: y, r: 3.5 }),
    ]),
    label("angle", across(0), y - 7, `${name} ${degrees(angle)}`),
  ];
}
