// The board of an RP2040 whose firmware runs in a worker: its display, and what it costs.
import { element as find, fetchText, find as within, row } from "./elements.js";
import { tidy, whole } from "./numbers.js";

const SIZE = 240;
/** Widths on the page: at least of the rest of the board, and at most of the display. */
const [LEAST_BOARD, MOST] = [120, 500];
/** Lines of the UART that are kept. */
const LINES = 8;

/** @param {string} id */
const element = (id) => find(`chip-${id}`);
/** @param {string} id */
const input = (id) => find(`chip-${id}`, HTMLInputElement);

/**
 * A picture that the display has received, compared with what it must. `stages` are the instructions
 * and cycles of each stage of all pixels.
 * @typedef {object} Picture
 * @property {string} line that the firmware printed
 * @property {string} name
 * @property {number} count of pixels
 * @property {number} differing
 * @property {string} checksum
 * @property {[number, number][]} stages
 * @property {number} nanos
 */

/** @typedef {{ column: number, row: number, pixels: Uint16Array }} Row of the display, from a column */

/** @typedef {{ failure?: string, rows?: Row[], nanos: number, wallMs: number, picture?: Picture }} Answer */

export class ChipView {
  #worker;
  #display = find("chip-display", HTMLCanvasElement);
  #canvas = /** @type {CanvasRenderingContext2D} */ (this.#display.getContext("2d"));
  #image = this.#canvas.createImageData(SIZE, SIZE);
  #stages;
  /** @type {string[]} */
  #lines = [];
  #isShown = false;
  /** Pictures after which the chip stops. */
  #last = Infinity;

  /** How many pictures the board has shown. */
  drawn = 0;
  /**
   * The last picture that is complete.
   * @type {Picture | undefined}
   */
  picture;

  /** Loads the view, the emulator and the firmware. */
  static async open() {
    const place = find("chip");
    place.innerHTML = await fetchText("chip.html");
    const worker = new Worker(new URL("chip-worker.js", import.meta.url), { type: "module" });
    const stages = await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => (data.stages ? resolve(data.stages) : reject(new Error(data.failure)));
      worker.onerror = (event) => reject(new Error(event.message ?? "the emulator could not be loaded"));
    }).catch((error) => {
      worker.terminate();
      throw error;
    });
    return new ChipView(worker, stages);
  }

  /**
   * @param {Worker} worker
   * @param {string[]} stages their names
   */
  constructor(worker, stages) {
    this.#worker = worker;
    this.#stages = stages;
    worker.onmessage = ({ data }) => this.#hear(data);
    worker.onerror = (event) => {
      throw new Error(event.message);
    };
    // Black until it receives pixels.
    const { data } = this.#image;
    for (let alpha = 3; alpha < data.length; alpha += 4) data[alpha] = 255;
    this.restore();
    new ResizeObserver(() => this.#fit()).observe(board());
    input("run").checked = true;
    element("run").addEventListener("input", () => {
      this.#last = Infinity;
      this.#order();
    });
    element("speed").addEventListener("input", () => worker.postMessage({ speed: Number(find("chip-speed", HTMLSelectElement).value) }));
    for (const step of ["row", "picture"]) element(step).addEventListener("click", () => this.#step(step));
    document.addEventListener("visibilitychange", () => this.#order());
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) this.#last = 1;
  }

  /** Draws on a canvas that is empty. */
  restore() {
    this.#canvas.putImageData(this.#image, 0, 0);
  }

  /** Called when the view is shown. */
  show() {
    this.#isShown = true;
    this.#fit();
    this.#order();
  }

  /** Called when the view is hidden: the chip waits. */
  hide() {
    this.#isShown = false;
    this.#order();
  }

  /** Lets the chip run if the visitor wants it and sees it. */
  #order() {
    const wanted = input("run").checked;
    this.#worker.postMessage({ run: wanted && this.#isShown && !document.hidden });
    if (!wanted) element("state").textContent = "The chip waits.";
  }

  /** @param {string} step */
  #step(step) {
    input("run").checked = false;
    this.#order();
    this.#worker.postMessage({ step });
  }

  /** @param {Answer} answer */
  #hear({ failure, rows, nanos, wallMs, picture }) {
    if (failure) throw new Error(failure);
    if (rows) this.#show(rows, nanos, wallMs);
    if (picture) this.#tell(picture);
  }

  /**
   * Shows new rows on the display, and the time.
   * @param {Row[]} rows
   * @param {number} nanos of the chip
   * @param {number} wallMs
   */
  #show(rows, nanos, wallMs) {
    for (const { column, row: y, pixels } of rows) pixels.forEach((pixel, x) => this.#set(column + x, y, pixel));
    if (rows.length > 0) this.#canvas.putImageData(this.#image, 0, 0);
    const last = rows.at(-1);
    const chipMs = nanos / 1e6;
    element("nanos").textContent = seconds(chipMs);
    element("wall").textContent = seconds(wallMs);
    element("slower").textContent = `${tidy(wallMs / chipMs)} times as long`;
    if (!input("run").checked) return;
    if (this.drawn === 0 && !last) element("state").textContent = "The display starts.";
    else if (last) element("state").textContent = `The display receives row ${last.row} of ${SIZE}.`;
  }

  /**
   * Sets a pixel from 5, 6 and 5 bits.
   * @param {number} x
   * @param {number} y
   * @param {number} pixel
   */
  #set(x, y, pixel) {
    const place = 4 * (y * SIZE + x);
    const [red, green, blue] = [pixel >> 11, (pixel >> 5) & 63, pixel & 31];
    const { data } = this.#image;
    data[place] = (red << 3) | (red >> 2);
    data[place + 1] = (green << 2) | (green >> 4);
    data[place + 2] = (blue << 3) | (blue >> 2);
  }

  /**
   * Tells about a complete picture.
   * @param {Picture} picture
   */
  #tell(picture) {
    this.picture = picture;
    this.drawn += 1;
    const { line, name, count, differing, checksum, stages } = picture;
    const printed = /checksum ([0-9a-f]{8})/.exec(line)?.[1] ?? "none";
    const isSame = differing === 0 && printed === checksum;
    element("differ").textContent = whole(differing);
    element("differ").classList.toggle("no", !isSame);
    element("of").textContent = `of ${whole(count)}`;
    element("name").textContent = name;
    element("checksum").textContent = printed;
    element("expected").textContent = checksum;
    // A black display costs nothing.
    if (stages.some(([, cycles]) => cycles > 0)) this.#tellCost(picture);
    this.#lines = [...this.#lines, line].slice(-LINES);
    element("lines").textContent = this.#lines.join("\n");
    if (this.drawn >= this.#last) {
      this.#last = Infinity;
      input("run").checked = false;
      this.#order();
    }
  }

  /** @param {Picture} picture */
  #tellCost({ count, stages, nanos }) {
    element("frame").textContent = seconds(nanos / 1e6);
    element("rate").textContent = (1e9 / nanos).toFixed(1);
    /** @type {(which: 0 | 1) => number} */
    const sum = (which) => stages.reduce((total, stage) => total + stage[which], 0) / count;
    element("instructions").textContent = whole(sum(0));
    element("cycles").textContent = whole(sum(1));
    this.#bars(stages.map(([, cycles]) => cycles / count));
  }

  /** @param {number[]} cycles */
  #bars(cycles) {
    const most = Math.max(...cycles);
    const rows = cycles.map((value, i) => {
      const line = row(this.#stages[i], [whole(value)]);
      line.cells[1].style.setProperty("--part", `${(100 * value) / most}%`);
      return line;
    });
    element("stages").replaceChildren(...rows);
  }

  /** Gives each pixel of the display a whole number of the screen's. */
  #fit() {
    const free = Math.min(board().clientWidth - LEAST_BOARD, MOST);
    const scale = Math.max(1, Math.floor((free * devicePixelRatio) / SIZE)) / devicePixelRatio;
    this.#display.style.width = `${SIZE * scale}px`;
  }
}

/** The board in the view. */
const board = () => within(document, "#chip .board");

/** @param {number} ms */
const seconds = (ms) => (ms < 1000 ? `${tidy(ms)} ms` : `${(ms / 1000).toFixed(2)} s`);
