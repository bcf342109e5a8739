// The lights in the picture: a small fixture where each hangs, and the pool of the selected one. A
// fixture moves its light, the pool aims it, and the wheel over the pool zooms it.
import { tidy } from "./numbers.js";
import { plain } from "./plain.js";
import { line, shape } from "./shapes.js";

/** Share of the picture per arrow key. */
const STEP = 0.02;

/** Factor on the angles per key or notch of the wheel. */
const WIDER = 1.08;

/** Largest number of notches in one turn of the wheel. */
const MOST = 5;

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Distance of a marker from the border, for a light beside the picture, in pixels. */
const MARGIN = 14;

export class Handles {
  #stage;
  #lights;
  #frame = document.getElementById("frame");
  #canvas = document.getElementById("view");
  #svg = document.getElementById("handles");
  #sides = [line("side", 0, 0, 0, 0), line("side", 0, 0, 0, 0)];
  #area = shape("path", { class: "area" });
  #outline = shape("path", { class: "outline" });
  #aim = slider("aim", [shape("circle", { class: "target", r: 22 }), shape("path", { class: "mark", d: "M-9 0H-3M3 0H9M0-9V-3M0 3V9" }), shape("circle", { class: "ring", r: 6 })]);
  #bodies = [];
  /** The size of the picture on the page, in pixels. */
  #size = { width: 1, height: 1 };
  /** Where the lights and their aims are, as shares of the picture. */
  #places = [];
  /** What is being dragged: its act, and its offset from the pointer. */
  #drag;
  #isMoving = false;

  /** Called with a change of the state. */
  onchange = () => {};
  /** Called with the number of a light that the visitor selects. */
  onselect = () => {};

  /**
   * @param {Stage} stage
   * @param {{selected: number}} lights the list of lights
   */
  constructor(stage, lights) {
    this.#stage = stage;
    this.#lights = lights;
    this.#aim.id = "handle-aim";
    this.#svg.append(this.#area, this.#outline, ...this.#sides, this.#aim);
    this.#join(this.#aim, () => this.#aiming());
    this.#join(this.#area, () => this.#aiming());
    for (const target of [this.#aim, this.#area]) {
      target.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    }
    this.#frame.addEventListener("pointerenter", () => this.show());
    this.#frame.addEventListener("focusin", () => this.show());
    // In the next frame: a change of size within this one would be an error of the observer.
    new ResizeObserver(() => requestAnimationFrame(() => this.show())).observe(this.#canvas);
  }

  /**
   * Draws the lights over the picture. While the picture moves they are shown only where the
   * pointer is over it or a light has the focus.
   */
  show(isMoving = this.#isMoving) {
    this.#isMoving = isMoving;
    this.#frame.classList.toggle("moves", isMoving);
    const isShown = this.#stage.showsHandles && this.#stage.lightCount > 0;
    this.#svg.toggleAttribute("hidden", !isShown);
    if (!isShown || (isMoving && !this.#frame.matches(":hover, :focus-within"))) return;
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
    while (this.#bodies.length > states.length) this.#bodies.pop().remove();
    while (this.#bodies.length < states.length) this.#bodies.push(this.#body(this.#bodies.length));
    for (const [light, state] of states.entries()) this.#place(light, state);
    this.#showPool(aspect);
  }

  /** Makes the handle of a light. */
  #body(light) {
    const body = slider("body", [
      shape("circle", { class: "target", r: 22 }),
      shape("path", { class: "case", d: "M-9-6H3L8-8V8L3 6H-9Z" }),
      shape("path", { class: "lens", d: "M8-8V8" }),
    ]);
    body.id = `handle-${light}`;
    this.#join(body, () => {
      if (light !== this.#lights.selected) this.onselect(light);
      return {
        from: this.#places[2 * light],
        act: ({ x, y, aspect }, isLevel) => this.#stage.dragLight(light, x, y, aspect, isLevel),
      };
    });
    this.#svg.append(body);
    return body;
  }

  /** Dragging the pool of the selected light. */
  #aiming() {
    const light = this.#lights.selected;
    return {
      from: this.#places[2 * light + 1],
      act: ({ x, y, aspect }) => this.#stage.dragAim(light, x, y, aspect),
    };
  }

  /** Moves the handle of a light to its place. A selected light beside the picture is at the border. */
  #place(light, { name, color, on, position }) {
    const [body, { width, height }] = [this.#bodies[light], this.#size];
    const isSelected = light === this.#lights.selected;
    const [at, aim] = [this.#pixels(2 * light), this.#pixels(2 * light + 1)];
    const isBeside = !(at.x >= 0 && at.x <= width && at.y >= 0 && at.y <= height);
    const isShown = !Number.isNaN(at.x) && (!isBeside || isSelected);
    body.toggleAttribute("hidden", !isShown);
    if (!isShown) return;
    const inside = (value, end) => Math.min(Math.max(value, MARGIN), end - MARGIN);
    const [x, y] = isBeside ? [inside(at.x, width), inside(at.y, height)] : [at.x, at.y];
    const turn = Number.isNaN(aim.x) ? 90 : (180 / Math.PI) * Math.atan2(aim.y - at.y, aim.x - at.x);
    body.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${turn.toFixed(1)})`);
    body.style.setProperty("--light", color);
    body.classList.toggle("selected", isSelected);
    body.classList.toggle("beside", isBeside);
    body.classList.toggle("off", !on);
    body.setAttribute("tabindex", isSelected ? 0 : -1);
    body.setAttribute("aria-label", `Position of light ${light + 1}, ${name}`);
    tellPlace(body, position);
  }

  #showPool(aspect) {
    const light = this.#lights.selected;
    const { isSpot, aim } = plain(this.#stage.light(light));
    const place = this.#pixels(2 * light + 1);
    const isSeen = isSpot && !Number.isNaN(place.x);
    for (const part of [this.#aim, this.#area, this.#outline, ...this.#sides]) part.toggleAttribute("hidden", !isSeen);
    if (!isSeen) return;
    this.#aim.setAttribute("transform", `translate(${place.x.toFixed(1)} ${place.y.toFixed(1)})`);
    this.#aim.setAttribute("aria-label", `Aim of light ${light + 1}`);
    tellPlace(this.#aim, aim);
    const pool = this.#stage.pool(light, aspect);
    const [ends, outline] = [pool.slice(0, 4), pool.slice(4)];
    const { width, height } = this.#size;
    let [path, area, isNew] = ["", "", true];
    for (let i = 0; i < outline.length; i += 2) {
      const [x, y] = [outline[i] * width, outline[i + 1] * height];
      if (Number.isNaN(x)) {
        isNew = true;
        continue;
      }
      const point = `${x.toFixed(1)} ${y.toFixed(1)}`;
      path += `${isNew ? "M" : "L"}${point}`;
      area += `${area === "" ? "M" : "L"}${point}`;
      isNew = false;
    }
    this.#outline.setAttribute("d", path);
    this.#area.setAttribute("d", area);
    const from = this.#pixels(2 * light);
    for (const [i, side] of this.#sides.entries()) {
      side.toggleAttribute("hidden", Number.isNaN(ends[2 * i]));
      if (Number.isNaN(ends[2 * i])) continue;
      side.setAttribute("x1", from.x);
      side.setAttribute("y1", from.y);
      side.setAttribute("x2", ends[2 * i] * width);
      side.setAttribute("y2", ends[2 * i + 1] * height);
    }
  }

  #pixels(place) {
    const { x, y } = this.#places[place];
    return { x: x * this.#size.width, y: y * this.#size.height };
  }

  /** Lets a target be dragged and moved by keys: `start` returns what it moves, and from where. */
  #join(target, start) {
    target.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      const { from, act } = start();
      const at = this.#pointer(event);
      this.#drag = { act, offset: { x: from.x - at.x, y: from.y - at.y } };
      target.setPointerCapture(event.pointerId);
      target.focus();
      event.preventDefault();
    });
    target.addEventListener("pointermove", (event) => {
      if (this.#drag && target.hasPointerCapture(event.pointerId)) this.#follow(event);
    });
    target.addEventListener("lostpointercapture", () => (this.#drag = undefined));
    target.addEventListener("keydown", (event) => this.#key(event, start));
  }

  /** Moves what is dragged to the pointer, once for each frame of the browser. */
  #follow(event) {
    const drag = this.#drag;
    const isScheduled = drag.to !== undefined;
    const { x, y } = this.#pointer(event);
    drag.to = { x: x + drag.offset.x, y: y + drag.offset.y, aspect: this.#aspect };
    drag.isLevel = event.shiftKey;
    if (isScheduled) return;
    requestAnimationFrame(() => {
      const to = drag.to;
      drag.to = undefined;
      this.onchange(() => drag.act(to, drag.isLevel));
    });
  }

  #pointer({ clientX, clientY }) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    return { x: (clientX - left) / width, y: (clientY - top) / height };
  }

  get #aspect() {
    return this.#size.width / this.#size.height;
  }

  #wheel(event) {
    if (event.ctrlKey || event.metaKey) return;
    const notches = Math.max(-MOST, Math.min(event.deltaY / [100, 3, 1][event.deltaMode], MOST));
    event.preventDefault();
    this.#zoom(WIDER ** notches);
  }

  #zoom(factor) {
    this.onchange(() => this.#stage.zoomLight(this.#lights.selected, factor));
  }

  #key(event, start) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    const zoom = { "+": WIDER, "=": WIDER, "-": 1 / WIDER }[event.key];
    if (!arrow && !zoom) return;
    event.preventDefault();
    if (zoom) return this.#zoom(zoom);
    const { from, act } = start();
    const to = { x: from.x + (STEP * arrow[0]) / this.#aspect, y: from.y + STEP * arrow[1], aspect: this.#aspect };
    this.onchange(() => act(to, event.shiftKey));
  }
}

/** A handle that moves in two dimensions. It has the role that screen readers move by arrow keys. */
function slider(kind, parts) {
  const handle = shape("g", { class: `handle ${kind}`, role: "slider", tabindex: 0 });
  handle.append(...parts);
  return handle;
}

/** Tells a position in metres to those who do not see it. */
function tellPlace(handle, [x, y, z]) {
  handle.setAttribute("aria-valuenow", tidy(x));
  handle.setAttribute("aria-valuetext", `x ${tidy(x)}, height ${tidy(y)}, z ${tidy(z)} metres`);
}
