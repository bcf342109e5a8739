// Interface for tests and measurements: `window.luminaire`.
import { Demo } from "./pkg/wasm_demo.js";
import { median } from "./numbers.js";

const pause = () => new Promise((resolve) => setTimeout(resolve));

export class Meter {
  #demo;
  #view;
  #formats;

  /** The comparison view; undefined until it is opened. */
  comparison;

  /** The scenes view; undefined until it is opened. */
  scenes;

  /** Opens the scenes view and returns it. */
  openScenes;

  constructor(demo, view, formats) {
    this.#demo = demo;
    this.#view = view;
    this.#formats = formats;
  }

  /** Number of pictures that were drawn, in all views. */
  get drawn() {
    return this.#view.drawn + (this.comparison?.drawn ?? 0) + (this.scenes?.drawn ?? 0);
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.#demo.pixels();
  }

  /** Requests a number format, as the select does: `fx16`, `fx32` or `f32`. */
  setFormat(name) {
    this.#formats.choose(name);
  }

  /**
   * Returns the largest difference between a picture in a format and one in f32, in displayed
   * codes.
   */
  statedError(format) {
    return Demo.statedError(format);
  }

  /**
   * Draws a number of pictures, with every pass whether anything changed or not, and returns the
   * medians in milliseconds. A frame is lighting, encoding and the transfer to the canvas, without
   * the geometry: the cost of a picture when lights move and the camera stands still.
   */
  async measure(frames) {
    const passes = { geometryMs: [], lightingMs: [], encodeMs: [], frameMs: [] };
    const demo = this.#demo;
    for (let i = 0; i < frames; i += 1) {
      this.#view.redraw();
      passes.geometryMs.push(demo.geometryMs);
      passes.lightingMs.push(demo.lightingMs);
      passes.encodeMs.push(demo.encodeMs);
      passes.frameMs.push(demo.lightingMs + demo.encodeMs + demo.showMs);
      // Yields to the browser, as between frames.
      await pause();
    }
    const medians = Object.fromEntries(Object.entries(passes).map(([name, times]) => [name, median(times)]));
    return { width: demo.width, height: demo.height, lights: demo.lightsOn, format: demo.format, ...medians };
  }

  /** Measures a scene: see `SceneMeter.measure`. Opens the scenes view for it. */
  async measureScene(name, frames, options) {
    return (await this.openScenes()).measure(name, frames, options);
  }
}
