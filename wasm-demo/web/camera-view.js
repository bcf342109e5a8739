// The canvas: redraws after a change, and lets the visitor move the camera.
import { hasFailed } from "./failure.js";

/** Rotation of the camera per key, in radians. */
const STEP = 0.08;

/** Zoom factor of a key or a notch of the wheel. */
const NEARER = 0.9;

/** Largest number of notches in one turn of the wheel. */
const MOST = 10;

/** A drag across the whole width of the canvas is one full turn, within the camera's limits. */
const TURN = 2 * Math.PI;

export class CameraView {
  #canvas;
  #camera;
  #frame = 0;
  #paused = true;
  /** Whether a picture is being drawn. */
  #isBusy = false;
  /** The time of a frame of the browser that began while a picture was being drawn. */
  #due;
  /** The pointers that are down, by their id: one turns the camera, two pinch. */
  #pointers = new Map();

  #drawing;

  /** How many pictures have been drawn. */
  drawn = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {object} camera
   * @param {(yaw: number, pitch: number) => void} camera.orbit by angles in radians
   * @param {(factor: number) => boolean} camera.zoom returns whether the camera has moved
   * @param {() => void} camera.reset
   * @param {(now: number) => Promise<{goesOn: boolean, show: () => boolean}>} camera.draw resolves when
   *   the picture can be shown; `show` returns whether there was something to show
   */
  constructor(canvas, camera) {
    this.#canvas = canvas;
    this.#camera = camera;
    canvas.addEventListener("pointerdown", (event) => this.#grab(event));
    canvas.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.#pointers.delete(event.pointerId));
    }
    canvas.addEventListener("dblclick", () => camera.reset());
    // Not passive: the wheel over the stage moves the camera, not the page.
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Draws with the next frame of the browser. Without a request no frame is scheduled. */
  request() {
    if (this.#frame === 0 && !this.#paused && !hasFailed()) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** While the canvas is hidden, as at first, nothing is drawn; changes are drawn afterwards. */
  pause(paused) {
    this.#paused = paused;
    if (!paused) this.request();
  }

  /** Whether a picture is being drawn or will be. */
  get isDrawing() {
    return this.#isBusy || this.#frame !== 0;
  }

  /** Draws what has changed, now or after the picture that is being drawn. */
  async draw(now) {
    while (this.#isBusy) await this.#drawing;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    await this.#start(now);
  }

  /** A frame of the browser. One picture is drawn at a time, and the newest state next. */
  #tick(now) {
    this.#frame = 0;
    if (this.#isBusy) this.#due = now;
    else this.#start(now);
  }

  #start(now) {
    this.#isBusy = true;
    this.#due = undefined;
    this.#drawing = this.#finish(this.#camera.draw(now));
    return this.#drawing;
  }

  async #finish(picture) {
    let drawn;
    try {
      drawn = await picture;
    } finally {
      this.#isBusy = false;
      // If the browser has begun a frame in the meantime, the workers begin the next picture before
      // this one is shown, so that they need not wait.
      const due = this.#due;
      if (due !== undefined && !hasFailed()) this.#start(due);
      if (drawn?.goesOn) this.request();
    }
    if (drawn.show()) this.drawn += 1;
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
      this.#camera.orbit((last.x - here.x) * scale, (here.y - last.y) * scale);
    } else {
      const before = this.#spread();
      this.#pointers.set(event.pointerId, here);
      if (before > 0 && this.#spread() > 0) this.#camera.zoom(before / this.#spread());
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
    // A notch is about 100 pixels, 3 lines or a fraction of a page, depending on the browser.
    const notches = Math.max(-MOST, Math.min(event.deltaY / [100, 3, 1][event.deltaMode], MOST));
    // At its limit the camera stays, and the page scrolls.
    if (this.#camera.zoom(NEARER ** -notches)) event.preventDefault();
  }

  #key(event) {
    const { orbit, zoom } = this.#camera;
    const act = {
      ArrowLeft: () => orbit(-STEP, 0),
      ArrowRight: () => orbit(STEP, 0),
      ArrowUp: () => orbit(0, STEP),
      ArrowDown: () => orbit(0, -STEP),
      "+": () => zoom(NEARER),
      "=": () => zoom(NEARER),
      "-": () => zoom(1 / NEARER),
    }[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  }
}
