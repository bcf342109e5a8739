// The canvas: redraws after a change, and lets the visitor move the camera.
import { hasFailed } from "./failure.js";

/** Rotation of the camera per key, in radians. */
const STEP = 0.08;

/** Zoom factor of a key or a notch of the wheel. */
const NEARER = 0.9;

/** Largest number of notches in one turn of the wheel. */
const MOST = 10;

/** Turn of a drag across the whole width of the canvas, within the camera's limits: a full one, or less than a quarter by a finger. */
const [TURN, SWIPE] = [2 * Math.PI, 0.45 * Math.PI];

/**
 * What is drawn: `orbit` turns by angles in radians, `zoom` returns whether the camera has moved,
 * `draw` calls `onfree` when the next picture may be begun, and resolves when the picture can be
 * shown; `show` returns whether there was something to show.
 * @typedef {{ goesOn: boolean, show: () => boolean }} Picture
 * @typedef {object} Camera
 * @property {(yaw: number, pitch: number) => void} orbit
 * @property {(factor: number) => boolean} zoom
 * @property {() => void} reset
 * @property {(now: number, onfree: () => void) => Promise<Picture>} draw
 */

export class CameraView {
  #canvas;
  #camera;
  #frame = 0;
  #paused = true;
  /** How many pictures are being drawn. */
  #begun = 0;
  /** Whether the next picture must wait. */
  #isBusy = false;
  /**
   * The time of a frame of the browser that began while the next picture had to wait.
   * @type {number | undefined}
   */
  #due;
  /**
   * The pointers that are down, by their id: one turns the camera, two pinch.
   * @type {Map<number, { x: number, y: number }>}
   */
  #pointers = new Map();

  /** @type {Promise<void> | undefined} */
  #drawing;

  /** How many pictures have been drawn. */
  drawn = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Camera} camera
   */
  constructor(canvas, camera) {
    this.#canvas = canvas;
    this.#camera = camera;
    canvas.addEventListener("pointerdown", (event) => this.#grab(event));
    canvas.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      canvas.addEventListener(end, (event) => this.#pointers.delete(event.pointerId));
    }
    canvas.addEventListener("dblclick", () => camera.reset());
    // Over all that lies on the picture. Not passive: it may move the camera, not the page.
    canvas.parentElement?.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.#key(event));
    document.addEventListener("visibilitychange", () => this.request());
  }

  /**
   * Draws with the next frame of the browser. Without a request no frame is scheduled, and none while
   * nobody sees the page: Firefox has a frame a second for it.
   */
  request() {
    if (this.#frame === 0 && !this.#paused && !document.hidden && !hasFailed()) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /**
   * While the canvas is hidden, as at first, nothing is drawn; changes are drawn afterwards.
   * @param {boolean} paused
   */
  pause(paused) {
    this.#paused = paused;
    if (!paused) this.request();
  }

  /** Whether a picture is being drawn or will be. A hidden page has its frame only when it is seen again. */
  get isDrawing() {
    return this.#begun > 0 || (this.#frame !== 0 && !document.hidden);
  }

  /**
   * Draws what has changed, now or after the picture that is being drawn.
   * @param {number} now
   */
  async draw(now) {
    while (this.#isBusy) await this.#drawing;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    await this.#start(now);
  }

  /**
   * A frame of the browser. The newest state is drawn next, when a worker is free.
   * @param {number} now
   */
  #tick(now) {
    this.#frame = 0;
    if (this.#isBusy) this.#due = now;
    else this.#start(now);
  }

  /** @param {number} now */
  #start(now) {
    this.#isBusy = true;
    this.#begun += 1;
    this.#due = undefined;
    let isFree = false;
    const onfree = () => {
      if (isFree) return;
      isFree = true;
      this.#isBusy = false;
      // If the browser has begun a frame in the meantime, the workers begin the next picture before
      // this one is shown, so that they need not wait.
      if (this.#due !== undefined && !hasFailed()) this.#start(this.#due);
    };
    this.#drawing = this.#finish(this.#camera.draw(now, onfree), onfree);
    return this.#drawing;
  }

  /**
   * @param {Promise<Picture>} picture
   * @param {() => void} onfree
   * @returns {Promise<void>}
   */
  async #finish(picture, onfree) {
    let drawn;
    try {
      drawn = await picture;
    } finally {
      this.#begun -= 1;
      onfree();
      if (drawn?.goesOn) this.request();
    }
    if (drawn?.show()) this.drawn += 1;
  }

  /** @param {PointerEvent} event */
  #grab(event) {
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const here = { x: event.clientX, y: event.clientY };
    if (this.#pointers.size === 1) {
      const scale = (event.pointerType === "touch" ? SWIPE : TURN) / this.#canvas.clientWidth;
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
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  /**
   * Zooms if the picture has the focus or fills the screen, or with Ctrl. Otherwise the page scrolls.
   * @param {WheelEvent} event
   */
  #wheel(event) {
    const isAsked = event.ctrlKey || event.metaKey;
    const isChosen = this.#canvas.parentElement?.contains(document.activeElement) || document.fullscreenElement;
    if (!isAsked && !isChosen) return;
    // A notch is about 100 pixels, 3 lines or a fraction of a page, depending on the browser.
    const notches = Math.max(-MOST, Math.min(event.deltaY / ([100, 3, 1][event.deltaMode] ?? 100), MOST));
    // At its limit the camera stays, and the page scrolls; with Ctrl the browser would zoom the page.
    if (this.#camera.zoom(NEARER ** -notches) || isAsked) event.preventDefault();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { orbit, zoom } = this.#camera;
    /** @type {Record<string, () => void>} */
    const acts = {
      ArrowLeft: () => orbit(-STEP, 0),
      ArrowRight: () => orbit(STEP, 0),
      ArrowUp: () => orbit(0, STEP),
      ArrowDown: () => orbit(0, -STEP),
      "+": () => zoom(NEARER),
      "=": () => zoom(NEARER),
      "-": () => zoom(1 / NEARER),
    };
    const act = acts[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  }
}
