// The canvas: redraws after a change, and lets the visitor move the camera.
import { aside, hasFailed } from "./failure.js";

/** Rotation of the camera per key, in radians. */
const STEP = 0.08;

/** Zoom factor of a key or a notch of the wheel. */
const NEARER = 0.9;

/** A drag across the whole width of the canvas is one full turn, within the camera's limits. */
const TURN = 2 * Math.PI;

export class StageView {
  #demo;
  #canvas;
  #frame = 0;
  #before = [];
  #after = [];
  #paused = false;
  /** The pointers that are down, by their id: one turns the camera, two pinch. */
  #pointers = new Map();

  /** How many pictures have been drawn. */
  drawn = 0;

  constructor(demo, canvas) {
    this.#demo = demo;
    this.#canvas = canvas;
    canvas.addEventListener("pointerdown", (event) => this.#grab(event));
    canvas.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.#pointers.delete(event.pointerId));
    }
    // Not passive: the wheel over the stage moves the camera, not the page.
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Calls `step(now)` before each picture; while it returns true, another picture follows. */
  before(step) {
    this.#before.push(step);
  }

  /** Calls `tell()` after each picture. */
  after(tell) {
    this.#after.push(tell);
  }

  /** Draws with the next frame of the browser. Without a request no frame is scheduled. */
  request() {
    if (this.#frame === 0 && !this.#paused && !hasFailed()) this.#frame = requestAnimationFrame((now) => this.draw(now));
  }

  /** While the canvas is hidden, nothing is drawn; changes are drawn afterwards. */
  pause(paused) {
    this.#paused = paused;
    if (!paused) this.request();
  }

  /** Draws what has changed, now. */
  draw(now) {
    this.#frame = 0;
    let goOn = false;
    for (const step of this.#before) goOn = step(now) || goOn;
    if (this.#demo.draw()) this.#tell();
    if (goOn) this.request();
  }

  /** Draws everything, changed or not, now. */
  redraw() {
    this.#demo.redraw();
    this.#tell();
  }

  #tell() {
    this.drawn += 1;
    for (const tell of this.#after) aside(tell);
  }

  #orbit(yaw, pitch) {
    this.#demo.orbit(yaw, pitch);
    this.request();
  }

  #zoom(factor) {
    this.#demo.zoom(factor);
    this.request();
  }

  #grab(event) {
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  #drag(event) {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const here = { x: event.clientX, y: event.clientY };
    if (this.#pointers.size === 1) {
      const scale = TURN / this.#canvas.clientWidth;
      this.#orbit((last.x - here.x) * scale, (here.y - last.y) * scale);
    } else {
      const before = this.#spread();
      this.#pointers.set(event.pointerId, here);
      if (before > 0 && this.#spread() > 0) this.#zoom(before / this.#spread());
    }
    this.#pointers.set(event.pointerId, here);
  }

  /** Distance between the first two pointers. */
  #spread() {
    const [a, b] = this.#pointers.values();
    return Math.hypot(a.x - b.x, a.y - b.y);
  }

  #wheel(event) {
    // With a modifier the wheel is the browser's own zoom.
    if (event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    // A notch is about 100 pixels, 3 lines or a fraction of a page, depending on the browser.
    const notches = event.deltaY / [100, 3, 1][event.deltaMode];
    this.#zoom(NEARER ** -notches);
  }

  #key(event) {
    const act = {
      ArrowLeft: () => this.#orbit(-STEP, 0),
      ArrowRight: () => this.#orbit(STEP, 0),
      ArrowUp: () => this.#orbit(0, STEP),
      ArrowDown: () => this.#orbit(0, -STEP),
      "+": () => this.#zoom(NEARER),
      "=": () => this.#zoom(NEARER),
      "-": () => this.#zoom(1 / NEARER),
    }[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  }
}
