// The lights in the picture: a small fixture where each hangs, and the pool of the selected one. A
// fixture moves its light, the pool aims it, and the wheel over the pool of a light with the focus zooms it.
import { element } from "./elements.js";
import { tidy } from "./numbers.js";
import { plain } from "./plain.js";
import { Press } from "./press.js";
import { line, shape } from "./shapes.js";

/** Share of the picture per arrow key. */
const STEP = 0.02;

/** Factor on the angles per key or notch of the wheel. */
const WIDER = 1.08;

/** Largest number of notches in one turn of the wheel. */
const MOST = 5;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Distance of a marker from the border, for a light beside the picture, in pixels. */
const MARGIN = 24;

/** @typedef {import("./pkg/wasm_demo.js").Stage} Stage */
/** @typedef {import("./plain.js").Plain<import("./pkg/wasm_demo.js").LightState>} Light */

/**
 * A place in the picture as shares of its sides.
 * @typedef {{ x: number, y: number }} Place
 * @typedef {Place & { aspect: number }} Target with the width of the picture divided by its height
 */

/**
 * What a handle moves, and from where.
 * @typedef {{ from: Place, act: (to: Target, isLevel: boolean) => void }} Start
 */

export class Handles {
  #stage;
  #lights;
  #frame = element("frame");
  #canvas = element("view", HTMLCanvasElement);
  #svg = element("handles", SVGElement);
  #sides = [line("side", 0, 0, 0, 0), line("side", 0, 0, 0, 0)];
  #area = shape("path", { class: "area" });
  #outline = shape("path", { class: "outline" });
  /** What the outline is. */
  #name = shape("text", { class: "middle" });
  #aim = slider("aim", [shape("circle", { class: "target", r: 22 }), shape("path", { class: "mark", d: "M-9 0H-3M3 0H9M0-9V-3M0 3V9" }), shape("circle", { class: "ring", r: 6 })]);
  /** @type {SVGElement[]} */
  #bodies = [];
  /** The size of the picture on the page, in pixels. */
  #size = { width: 1, height: 1 };
  /**
   * Where the lights and their aims are.
   * @type {Place[]}
   */
  #places = [];
  /**
   * What is being dragged: its act, its offset from the pointer, and where it is to go next.
   * @type {{ act: Start["act"], offset: Place, press: Press, to?: Target, isLevel?: boolean } | undefined}
   */
  #drag;

  /** Called with a change of the state. */
  onchange = /** @type {(act: () => void) => void} */ (() => {});
  /** Called with the number of a light that the visitor selects. */
  onselect = /** @type {(light: number) => void} */ (() => {});

  /**
   * @param {Stage} stage
   * @param {{selected: number}} lights the list of lights
   */
  constructor(stage, lights) {
    this.#stage = stage;
    this.#lights = lights;
    this.#aim.id = "handle-aim";
    this.#svg.append(this.#area, this.#outline, ...this.#sides, this.#name, this.#aim);
    this.#name.textContent = "field, 10 %";
    this.#join(this.#aim, () => this.#aiming());
    // An area cannot have the focus, by which the wheel zooms.
    this.#join(this.#area, () => this.#aiming(), this.#aim);
    for (const target of [this.#aim, this.#area]) {
      target.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    }
    this.#frame.addEventListener("pointerenter", () => this.show());
    this.#frame.addEventListener("focusin", () => this.show());
    // In the next frame: a change of size within this one would be an error of the observer.
    new ResizeObserver(() => requestAnimationFrame(() => this.show())).observe(this.#canvas);
  }

  /**
   * Called after each picture. While the picture moves, the lights over it are shown and follow it only
   * where the pointer is over it or a light has the focus.
   * @param {boolean} isMoving
   */
  follow(isMoving) {
    this.#frame.classList.toggle("moves", isMoving);
    if (!isMoving || this.#frame.matches(":hover, :focus-within")) this.show();
  }

  /** Draws the lights over the picture. */
  show() {
    const isShown = this.#stage.get("handles") && this.#stage.lightCount > 0;
    this.#svg.toggleAttribute("hidden", !isShown);
    if (!isShown) return;
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    if (width === 0 || height === 0) return;
    this.#size = { width, height };
    this.#svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#svg.style.width = `${width}px`;
    this.#svg.style.height = `${height}px`;
    const aspect = width / height;
    const pairs = this.#stage.places(aspect);
    this.#places = Array.from({ length: pairs.length / 2 }, (_, i) => ({ x: pairs[2 * i], y: pairs[2 * i + 1] }));
    const states = this.#stage.lights().map(plain);
    while (this.#bodies.length > states.length) this.#bodies.pop()?.remove();
    while (this.#bodies.length < states.length) this.#bodies.push(this.#body(this.#bodies.length));
    for (const [light, state] of states.entries()) this.#place(light, state);
    this.#showPool(aspect);
  }

  /**
   * Makes the handle of a light.
   * @param {number} light
   */
  #body(light) {
    const body = slider("body", [
      shape("circle", { class: "target", r: 22 }),
      shape("path", { class: "case", d: "M-9-6H3L8-8V8L3 6H-9Z" }),
      shape("path", { class: "lens", d: "M8-8V8" }),
    ]);
    body.id = `handle-${light}`;
    /** @type {() => Start} */
    const start = () => {
      if (light !== this.#lights.selected) this.onselect(light);
      return {
        from: this.#places[2 * light],
        act: ({ x, y, aspect }, isLevel) => this.#stage.dragLight(light, x, y, aspect, isLevel),
      };
    };
    this.#join(body, start);
    this.#svg.append(body);
    return body;
  }

  /**
   * Dragging the pool of the selected light.
   * @returns {Start}
   */
  #aiming() {
    const light = this.#lights.selected;
    return {
      from: this.#places[2 * light + 1],
      act: ({ x, y, aspect }) => this.#stage.dragAim(light, x, y, aspect),
    };
  }

  /**
   * Moves the handle of a light to its place. A selected light beside the picture is at the border.
   * @param {number} light
   * @param {Light} state
   */
  #place(light, { name, color, on, position }) {
    const [body, { width, height }] = [this.#bodies[light], this.#size];
    const isSelected = light === this.#lights.selected;
    const [at, aim] = [this.#pixels(2 * light), this.#pixels(2 * light + 1)];
    const isBeside = !(at.x >= 0 && at.x <= width && at.y >= 0 && at.y <= height);
    const isShown = !Number.isNaN(at.x) && (!isBeside || isSelected);
    body.toggleAttribute("hidden", !isShown);
    // Chromium tells of hidden parts of a drawing, too.
    body.setAttribute("tabindex", isSelected ? "0" : "-1");
    body.setAttribute("aria-label", `Position of light ${light + 1}, ${name}`);
    tellPlace(body, position, this.#stage.farthest);
    if (!isShown) return;
    /** @type {(value: number, end: number) => number} */
    const inside = (value, end) => Math.min(Math.max(value, MARGIN), end - MARGIN);
    const [x, y] = isBeside ? [inside(at.x, width), inside(at.y, height)] : [at.x, at.y];
    const turn = Number.isNaN(aim.x) ? 90 : (180 / Math.PI) * Math.atan2(aim.y - at.y, aim.x - at.x);
    body.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${turn.toFixed(1)})`);
    body.style.setProperty("--light", color);
    body.classList.toggle("selected", isSelected);
    body.classList.toggle("beside", isBeside);
    body.classList.toggle("off", !on);
  }

  /** @param {number} aspect */
  #showPool(aspect) {
    const light = this.#lights.selected;
    const { isSpot, aim } = plain(this.#stage.light(light));
    const place = this.#pixels(2 * light + 1);
    const isSeen = isSpot && !Number.isNaN(place.x);
    for (const part of [this.#aim, this.#area, this.#outline, this.#name, ...this.#sides]) part.toggleAttribute("hidden", !isSeen);
    this.#aim.setAttribute("aria-label", `Aim of light ${light + 1}`);
    tellPlace(this.#aim, aim, this.#stage.farthest);
    if (!isSeen) return;
    this.#aim.setAttribute("transform", `translate(${place.x.toFixed(1)} ${place.y.toFixed(1)})`);
    const pool = this.#stage.pool(light, aspect);
    const [ends, outline] = [pool.slice(0, 4), pool.slice(4)];
    const { width, height } = this.#size;
    let [path, lines, isCut, top] = ["", "", true, { x: 0, y: Infinity }];
    for (let i = 0; i < outline.length; i += 2) {
      const isEnd = Number.isNaN(outline[i]);
      const [x, y] = [outline[i] * width, outline[i + 1] * height];
      const point = `${x.toFixed(1)} ${y.toFixed(1)}`;
      if (y < top.y) top = { x, y };
      if (!isEnd) [path, lines] = [`${path}${path && "L"}${point}`, `${lines}${isCut ? "M" : "L"}${point}`];
      isCut = isEnd;
    }
    this.#area.setAttribute("d", path && `M${path}Z`);
    this.#outline.setAttribute("d", lines && `${lines}${isCut ? "" : "Z"}`);
    // Above the outline, within the picture.
    this.#name.setAttribute("x", String(Math.max(44, Math.min(top.x, width - 44))));
    this.#name.setAttribute("y", String(Math.max(16, Math.min(top.y - 6, height - 8))));
    const from = this.#pixels(2 * light);
    for (const [i, side] of this.#sides.entries()) {
      side.toggleAttribute("hidden", Number.isNaN(ends[2 * i]));
      if (Number.isNaN(ends[2 * i])) continue;
      const to = { x: ends[2 * i] * width, y: ends[2 * i + 1] * height };
      const places = { x1: from.x, y1: from.y, x2: to.x, y2: to.y };
      for (const [name, value] of Object.entries(places)) side.setAttribute(name, String(value));
    }
  }

  /** @param {number} place */
  #pixels(place) {
    const { x, y } = this.#places[place];
    return { x: x * this.#size.width, y: y * this.#size.height };
  }

  /**
   * Lets a target be dragged and moved by keys.
   * @param {SVGElement} target
   * @param {() => Start} start
   * @param {SVGElement} [focused] what a press gives the focus
   */
  #join(target, start, focused = target) {
    target.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      const { from, act } = start();
      const at = this.#pointer(event);
      this.#drag = { act, offset: { x: from.x - at.x, y: from.y - at.y }, press: new Press(event) };
      target.setPointerCapture(event.pointerId);
      focused.focus();
      event.preventDefault();
    });
    target.addEventListener("pointermove", (event) => {
      if (this.#drag && target.hasPointerCapture(event.pointerId)) this.#follow(event);
    });
    target.addEventListener("pointercancel", () => {
      if (this.#drag) this.#drag.to = undefined;
    });
    target.addEventListener("lostpointercapture", () => (this.#drag = undefined));
    target.addEventListener("keydown", (event) => this.#key(event, start));
  }

  /**
   * Moves what is dragged to the pointer, once for each frame of the browser.
   * @param {PointerEvent} event
   */
  #follow(event) {
    const drag = this.#drag;
    if (!drag?.press.isDrag(event)) return;
    const isScheduled = drag.to !== undefined;
    const { x, y } = this.#pointer(event);
    drag.to = { x: x + drag.offset.x, y: y + drag.offset.y, aspect: this.#aspect };
    drag.isLevel = event.shiftKey;
    if (isScheduled) return;
    requestAnimationFrame(() => {
      const { to, isLevel = false } = drag;
      drag.to = undefined;
      if (to) this.onchange(() => drag.act(to, isLevel));
    });
  }

  /** @param {PointerEvent} event */
  #pointer({ clientX, clientY }) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    return { x: (clientX - left) / width, y: (clientY - top) / height };
  }

  get #aspect() {
    return this.#size.width / this.#size.height;
  }

  /**
   * Zooms the light if a light has the focus. Otherwise the wheel moves the camera or the page.
   * @param {WheelEvent} event
   */
  #wheel(event) {
    if (event.ctrlKey || event.metaKey || !this.#svg.contains(document.activeElement)) return;
    const notches = Math.max(-MOST, Math.min(event.deltaY / ([100, 3, 1][event.deltaMode] ?? 100), MOST));
    event.preventDefault();
    event.stopPropagation();
    this.#zoom(WIDER ** notches);
  }

  /** @param {number} factor */
  #zoom(factor) {
    this.onchange(() => this.#stage.zoomLight(this.#lights.selected, factor));
  }

  /**
   * @param {KeyboardEvent} event
   * @param {() => Start} start
   */
  #key(event, start) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    /** @type {Record<string, number>} */
    const zooms = { "+": WIDER, "=": WIDER, "-": 1 / WIDER };
    const zoom = zooms[event.key];
    if (!arrow && !zoom) return;
    event.preventDefault();
    if (zoom) return this.#zoom(zoom);
    const { from, act } = start();
    const to = { x: from.x + (STEP * arrow[0]) / this.#aspect, y: from.y + STEP * arrow[1], aspect: this.#aspect };
    this.onchange(() => act(to, event.shiftKey));
  }
}

/**
 * A handle that moves in two dimensions. It has the role that screen readers move by arrow keys.
 * @param {string} kind
 * @param {SVGElement[]} parts
 */
function slider(kind, parts) {
  const handle = shape("g", { class: `handle ${kind}`, role: "slider", tabindex: 0 });
  handle.append(...parts);
  return handle;
}

/**
 * Tells a position in metres to those who do not see it. Without its ends a slider is from 0 to 100.
 * @param {SVGElement} handle
 * @param {Float32Array} place
 * @param {number} farthest the largest coordinate
 */
function tellPlace(handle, [x = 0, y = 0, z = 0], farthest) {
  handle.setAttribute("aria-valuemin", String(-farthest));
  handle.setAttribute("aria-valuemax", String(farthest));
  handle.setAttribute("aria-valuenow", String(tidy(x)));
  handle.setAttribute("aria-valuetext", `x ${tidy(x)}, height ${tidy(y)}, z ${tidy(z)} metres`);
}
