// Error against cost, both logarithmic: one mark for each evaluation of a light.
import { label, line, shape } from "./shapes.js";

const HEIGHT = 300;
const [TOP, BOTTOM] = [40, HEIGHT - 44];
/** Margins beside the box, in pixels: for numbers of the error, and for half a number of the cost. */
const [LEFT, RIGHT] = [60, 24];

/**
 * The points that no other beats: none costs less and errs no more, or errs less and costs no more.
 * @template {{cost: number, error: number}} Point
 * @param {Point[]} points
 * @returns {Point[]} from the cheapest to the most exact
 */
export function front(points) {
  const sorted = [...points].sort((a, b) => a.cost - b.cost || a.error - b.error);
  let least = Infinity;
  return sorted.filter(({ error }) => error < least && ((least = error), true));
}

/**
 * Returns the powers of ten that enclose some numbers, as exponents.
 * @param {number[]} values
 */
function decades(values) {
  const logs = values.filter((value) => value > 0).map(Math.log10);
  return [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs) + 1e-9)];
}

/**
 * A logarithmic scale of an axis, and its ticks.
 * @param {number[]} values
 * @param {number} from
 * @param {number} to
 */
function scale(values, from, to) {
  const [low, high] = decades(values);
  /** @type {(value: number) => number} */
  const place = (value) => from + ((to - from) * (Math.log10(Math.max(value, 10 ** low)) - low)) / Math.max(high - low, 1);
  const every = Math.ceil((high - low) / 6);
  const ticks = Array.from({ length: Math.floor((high - low) / every) + 1 }, (_, i) => 10 ** (low + i * every));
  return { place, ticks };
}

/** @param {number} value */
const power = (value) => (value >= 0.001 && value <= 10_000 ? value.toLocaleString("en") : `1e${Math.round(Math.log10(value))}`);

/**
 * Draws the points.
 * @param {SVGElement} svg
 * @param {{name: string, cost: number, error: number, isStage: boolean, isPicked: boolean, onpick?: () => void}[]} points
 *   with what a click on each does
 * @param {{tolerance: number, cost: string, error: string}} words the largest error that is allowed, and
 *   the names of the axes
 */
export function draw(svg, points, { tolerance, cost, error }) {
  // A pixel of the page each, so that words have the page's size on every screen.
  const width = Math.max(svg.clientWidth, 240);
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
  const end = width - RIGHT;
  const x = scale(points.map((point) => point.cost), LEFT, end);
  const y = scale([...points.map((point) => point.error), tolerance], BOTTOM, TOP);
  const ahead = front(points);
  svg.replaceChildren(
    ...x.ticks.flatMap((tick) => [
      line("level", x.place(tick), TOP, x.place(tick), BOTTOM),
      label("middle", x.place(tick), BOTTOM + 18, power(tick)),
    ]),
    ...y.ticks.flatMap((tick) => [
      line("level", LEFT, y.place(tick), end, y.place(tick)),
      label("end", LEFT - 8, y.place(tick) + 4, power(tick)),
    ]),
    label("middle", (LEFT + end) / 2, HEIGHT - 6, cost),
    label("start", 0, 14, error),
    line("tolerance", LEFT, y.place(tolerance), end, y.place(tolerance)),
    label("end allowed", end, y.place(tolerance) - 5, "allowed"),
    shape("path", { class: "front", d: steps(ahead.map((point) => [x.place(point.cost), y.place(point.error)])) }),
    ...points.flatMap((point, i) => {
      const [left, top] = [x.place(point.cost), y.place(point.error)];
      const kinds = ["point", point.isStage && "current", point.isPicked && "picked", !ahead.includes(point) && "beaten"];
      const isRight = left > end - 90;
      // Of two names at one place, the second is below its point.
      const isTaken = points.slice(0, i).some((other) => Math.abs(x.place(other.cost) - left) < 90 && Math.abs(y.place(other.error) - top) < 16);
      return [
        ...(point.isPicked ? [shape("circle", { class: "ring", cx: left, cy: top, r: 11 })] : []),
        shape("circle", { class: kinds.filter(Boolean).join(" "), cx: left, cy: top, r: point.isStage ? 6.5 : 4.5 }),
        ...(point.onpick ? [pressable(shape("circle", { class: "press", cx: left, cy: top, r: 14 }), point.name, point.onpick)] : []),
        // Above the staircase, which leaves the point to the right, and comes from above or from the left.
        label(isRight ? "end name" : "start name", left + (isRight ? -9 : 9), top + (isTaken ? 22 : -7), point.name),
      ];
    }),
  );
  svg.setAttribute(
    "aria-label",
    `Error against cost: ${points.map((p) => `${p.name} errs by ${power(p.error)} for ${Math.round(p.cost)} instructions`).join("; ")}`,
  );
}

/**
 * Makes a shape a button.
 * @param {SVGElement} place
 * @param {string} name
 * @param {() => void} act
 */
function pressable(place, name, act) {
  for (const [attribute, value] of [["role", "button"], ["tabindex", "0"], ["aria-label", `Draw the picture in ${name}`]]) {
    place.setAttribute(attribute, value);
  }
  place.addEventListener("click", act);
  place.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    act();
  });
  return place;
}

/**
 * A staircase through points: between two of the front, the cheaper one is what can be had.
 * @param {number[][]} places
 */
function steps(places) {
  return places.map(([x, y], i) => (i === 0 ? `M${x} ${y}` : `H${x}V${y}`)).join("");
}
