// The canvases of the picture and its map.
import { Painter } from "./pkg/wasm_demo.js";

export class Screen {
  #canvas;
  #map;
  #contexts;
  /** The picture: RGBA, sRGB, eight bits. */
  #image;
  #counts = new Uint16Array();

  constructor(canvas, map) {
    this.#canvas = canvas;
    this.#map = map;
    this.#contexts = [canvas, map].map((canvas) => canvas.getContext("2d"));
    if (this.#contexts.includes(null)) {
      throw new Error("The browser gives no 2d context for the canvas: allow canvas for this page, or use another browser.");
    }
  }

  /** The last picture: RGBA, sRGB, eight bits. */
  get pixels() {
    return this.#image?.data ?? new Uint8ClampedArray();
  }

  /** Counts for the map of the last picture, one for each block of pixels. */
  get counts() {
    return this.#counts;
  }

  /** Puts the parts of a picture together. */
  gather(parts, { width, height }) {
    if (this.#image?.width !== width || this.#image.height !== height) {
      for (const canvas of [this.#canvas, this.#map]) Object.assign(canvas, { width, height });
      this.#image = new ImageData(width, height);
    }
    interleave(parts.map(({ pixels }) => pixels), 4 * width, this.#image.data);
  }

  /** Takes the counts for the map. */
  count(parts, height) {
    const length = parts.reduce((sum, { counts }) => sum + counts.length, 0);
    if (this.#counts.length !== length) this.#counts = new Uint16Array(length);
    interleave(parts.map(({ counts }) => counts), length / height, this.#counts);
  }

  /** Shows the picture. */
  show() {
    this.#contexts[0].putImageData(this.#image, 0, 0);
  }

  /** Shows a map. */
  showMap(pixels) {
    this.#contexts[1].putImageData(new ImageData(pixels, this.#image.width), 0, 0);
  }
}

/** Writes the stripes of each share to their places in the whole. `row` is the length of a row. */
function interleave(shares, row, whole) {
  const stripe = row * Painter.stripeRows();
  shares.forEach((part, share) => {
    if (!part) return;
    for (let from = 0, place = share * stripe; from < part.length; from += stripe, place += shares.length * stripe) {
      whole.set(part.subarray(from, from + stripe), place);
    }
  });
}
