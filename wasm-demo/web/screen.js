// The canvases of the picture and its map.
import { Composite, Painter } from "./pkg/wasm_demo.js";

/** @typedef {Awaited<ReturnType<import("./share.js").Share["draw"]>>} Part a share of a picture */

export class Screen {
  #canvas;
  #map;
  /** @type {CanvasRenderingContext2D[]} */
  #contexts;
  #composite = new Composite();
  #size = { width: 0, height: 0 };
  #counts = new Uint16Array();

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {HTMLCanvasElement} map
   */
  constructor(canvas, map) {
    this.#canvas = canvas;
    this.#map = map;
    this.#contexts = [canvas, map].flatMap((canvas) => canvas.getContext("2d") ?? []);
    if (this.#contexts.length < 2) {
      throw new Error("The browser gives no 2d context for the canvas: allow canvas for this page, or use another browser.");
    }
  }

  /** The last picture: RGBA, sRGB, eight bits. */
  get pixels() {
    return this.#composite.pixels();
  }

  /** The width of the last picture in pixels. */
  get width() {
    return this.#size.width;
  }

  /** Counts for the map of the last picture, one for each block of pixels. */
  get counts() {
    return this.#counts;
  }

  /**
   * Puts the parts of a picture together.
   * @param {Part[]} parts
   * @param {{ width: number, height: number }} size
   */
  gather(parts, { width, height }) {
    this.#size = { width, height };
    this.#composite.begin(width, height, parts.length);
    parts.forEach(({ pixels, marks }, share) => pixels && marks && this.#composite.put(share, pixels, marks));
    this.#composite.mix();
  }

  /**
   * Takes the counts for the map.
   * @param {Part[]} parts
   * @param {number} height
   */
  count(parts, height) {
    const length = parts.reduce((sum, { counts }) => sum + counts.length, 0);
    if (this.#counts.length !== length) this.#counts = new Uint16Array(length);
    interleave(parts.map(({ counts }) => counts), length / height, this.#counts);
  }

  /** Shows the picture. */
  show() {
    const { width, height } = this.#size;
    // Setting a size clears a canvas.
    for (const canvas of [this.#canvas, this.#map]) {
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    }
    this.#composite.show(this.#contexts[0]);
  }

  /**
   * Shows a map.
   * @param {Uint8ClampedArray} pixels
   */
  showMap(pixels) {
    this.#contexts[1].putImageData(new ImageData(/** @type {Uint8ClampedArray<ArrayBuffer>} */ (pixels), this.#size.width), 0, 0);
  }
}

/**
 * Writes the stripes of each share to their places in the whole.
 * @param {Uint16Array[]} shares
 * @param {number} row the length of a row
 * @param {Uint16Array} whole
 */
function interleave(shares, row, whole) {
  const stripe = row * Painter.stripeRows();
  shares.forEach((part, share) => {
    if (!part) return;
    for (let from = 0, place = share * stripe; from < part.length; from += stripe, place += shares.length * stripe) {
      whole.set(part.subarray(from, from + stripe), place);
    }
  });
}
