// The intensity of a light across its axis, with a handle for each of its angles.
import { element } from "./elements.js";
import { degrees, tidy } from "./numbers.js";
import { plain } from "./plain.js";
import { Press } from "./press.js";
import { label, line, shape } from "./shapes.js";

/** @typedef {import("./plain.js").Plain<import("./pkg/wasm_demo.js").LightState>} Light */
/** @typedef {(angle: number) => number} Across the horizontal position of an angle off the axis, in degrees */
/** @typedef {typeof MARKS[number]} Mark */

const SAMPLES = 241;

/** The drawing's box, in the units of the SVG's viewBox. */
export const BOX = { left: 52, right: 428, top: 12, bottom: 180 };
const MIDDLE = (BOX.left + BOX.right) / 2;
const HALF = (BOX.right - BOX.left) / 2;
const WIDTH = 440;

/** The angles of a light, with their intensities. */
const MARKS = /** @type {const} */ ([
  { name: "beam", level: 0.5, words: "Beam angle, at half the intensity" },
  { name: "field", level: 0.1, words: "Field angle, at a tenth of the intensity" },
]);

/** Factor on an angle per key, and per key with Shift. */
const STEPS = [1.01, 1.1];

/**
 * Vertical positions of intensities.
 * @param {number} intensity
 */
export const height = (intensity) => BOX.bottom + (BOX.top - BOX.bottom) * intensity;

/**
 * Returns a tick distance of 1, 2 or 5 times a power of ten, for two to five ticks on a side.
 * @param {number} reach
 */
function tickStep(reach) {
  const power = 10 ** Math.floor(Math.log10(reach / 2));
  return power * ([5, 2].find((factor) => reach / (power * factor) >= 2) ?? 1);
}

export class Curve {
  #stage;
  #svg = element("curve", SVGElement);
  #drawn = shape("g", {});
  #handles;
  #title = element("curve-title");
  #format = element("curve-format");
  /** The angle at the right end of the drawing, which stays the same during a drag. */
  #reach = 1;
  /** @type {Press | undefined} */
  #press;

  /**
   * Called with the name of an angle, a value in degrees, and the handle; with nothing when a drag has
   * ended.
   */
  onset = /** @type {(name?: string, value?: number, handle?: SVGElement) => void} */ (() => {});

  /** @param {import("./pkg/wasm_demo.js").Stage} stage */
  constructor(stage) {
    this.#stage = stage;
    this.#handles = MARKS.map((mark) => this.#handle(mark));
    this.#svg.append(this.#drawn, ...this.#handles);
  }

  /**
   * Draws the curve of a light, evaluated by the module in the current number format.
   * @param {number} light
   */
  draw(light) {
    if (light >= this.#stage.lightCount) return;
    const kept = this.#press ? this.#reach : undefined;
    const points = this.#stage.curve(light, SAMPLES, kept);
    if (points.length === 0) return;
    const state = plain(this.#stage.light(light));
    const reach = (this.#reach = points[points.length - 2]);
    /** @type {Across} */
    const across = (angle) => MIDDLE + HALF * (angle / reach);
    this.#svg.style.setProperty("--light", state.color);
    this.#drawn.replaceChildren(
      ...levels(),
      ...ticks(reach, across),
      glow(points, across),
      shape("path", { class: "trace", d: path(points, across) }),
      ...MARKS.flatMap(({ name, level }) => mark(name, state[name], level, across)),
    );
    MARKS.forEach((mark, i) => tell(this.#handles[i], mark, state, across));
    this.#title.textContent = `${state.name}: intensity across the axis`;
    this.#format.textContent = `evaluated in ${this.#stage.get("format")}`;
    this.#svg.setAttribute("aria-label", describe(state));
  }

  /** @param {Mark} mark */
  #handle({ name, words }) {
    const handle = shape("g", { class: "handle", role: "slider", tabindex: 0, "aria-label": words });
    handle.append(...[0, 1].flatMap(() => [shape("circle", { class: "target", r: 15 }), shape("circle", { class: "dot", r: 6 })]));
    /** @type {(value: number) => void} */
    const set = (value) => this.onset(`fit-${name}`, Math.min(Math.max(value, 1e-3), 179.9), handle);
    handle.addEventListener("pointerdown", (event) => {
      handle.setPointerCapture(event.pointerId);
      this.#press = new Press(event);
    });
    handle.addEventListener("pointermove", (event) => {
      if (!handle.hasPointerCapture(event.pointerId) || !this.#press?.isDrag(event)) return;
      const { left, width } = this.#svg.getBoundingClientRect();
      const x = ((event.clientX - left) * WIDTH) / width;
      set(round((2 * this.#reach * Math.abs(x - MIDDLE)) / HALF));
    });
    handle.addEventListener("lostpointercapture", () => {
      this.#press = undefined;
      this.onset();
    });
    handle.addEventListener("keydown", (event) => {
      /** @type {Record<string, number>} */
      const turns = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
      const turn = turns[event.key];
      if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      set(round(Number(handle.getAttribute("aria-valuenow")) * STEPS[Number(event.shiftKey)] ** turn));
    });
    return handle;
  }
}

/** @param {number} value */
const round = (value) => Number(value.toPrecision(4));

/** @param {Light} light */
const describe = ({ name, beam, field, outer }) =>
  `${name}: half the intensity at ${degrees(beam / 2)} off axis, a tenth at ${degrees(field / 2)}, ` +
  `none from ${degrees(outer / 2)}`;

/** The lines of full, half, tenth and no intensity. */
export function levels() {
  return [1, 0.5, 0.1, 0].flatMap((level) => [
    line("level", BOX.left, height(level), BOX.right, height(level)),
    label("end", BOX.left - 8, height(level) + 4, `${100 * level} %`),
  ]);
}

/**
 * The axis: degrees off the light's axis, to both sides.
 * @param {number} reach
 * @param {Across} across
 */
function ticks(reach, across) {
  const step = tickStep(reach);
  const count = Math.floor(reach / step);
  return Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * step).flatMap((angle) => [
    line("tick", across(angle), BOX.bottom, across(angle), BOX.bottom + 4),
    label("middle", across(angle), BOX.bottom + 19, degrees(angle)),
  ]);
}

/**
 * @param {Float32Array} points angles and intensities in turn
 * @param {Across} across
 */
function path(points, across) {
  let path = "";
  for (let i = 0; i < points.length; i += 2) {
    path += `${i === 0 ? "M" : "L"}${across(points[i]).toFixed(2)} ${height(points[i + 1]).toFixed(2)}`;
  }
  return path;
}

/**
 * The light under the curve.
 * @param {Float32Array} points
 * @param {Across} across
 */
function glow(points, across) {
  return shape("path", { class: "glow", d: `${path(points, across)}L${BOX.right} ${BOX.bottom}L${BOX.left} ${BOX.bottom}Z` });
}

/**
 * Draws a full angle at its intensity level, from one side to the other.
 * @param {string} name
 * @param {number} angle
 * @param {number} level
 * @param {Across} across
 */
function mark(name, angle, level, across) {
  const [left, right, y] = [across(-angle / 2), across(angle / 2), height(level)];
  return [
    line("span", left, y, right, y),
    ...[left, right].map((x) => line("drop", x, y, x, BOX.bottom)),
    label("middle angle", across(0), y - 7, `${name} ${degrees(angle)}`),
  ];
}

/**
 * Moves a handle to its angle.
 * @param {SVGElement} handle
 * @param {Mark} mark
 * @param {Light} state
 * @param {Across} across
 */
function tell(handle, { name, level }, state, across) {
  const angle = state[name];
  const range = state.reach.slice(name === "beam" ? 0 : 2);
  for (const [i, circle] of [...handle.children].entries()) {
    circle.setAttribute("cx", String(across((i < 2 ? angle : -angle) / 2)));
    circle.setAttribute("cy", String(height(level)));
  }
  handle.setAttribute("aria-valuenow", String(tidy(angle)));
  handle.setAttribute("aria-valuetext", `${tidy(angle)}°`);
  handle.setAttribute("aria-valuemin", String(tidy(range[0] ?? angle)));
  handle.setAttribute("aria-valuemax", String(tidy(range[1] ?? angle)));
}
