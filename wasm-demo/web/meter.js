// What tests and measurements ask of the page: `window.luminaire`.
import { Demo } from "./pkg/wasm_demo.js";
import { median } from "./numbers.js";

const pause = () => new Promise((resolve) => setTimeout(resolve));

export class Meter {
  #demo;
  #view;
  #formats;

  /** The view of the comparison; nothing until it is opened. */
  comparison;

  /** The view of the scenes; nothing until it is opened. */
  scenes;

  /** Opens the view of the scenes, and answers it. */
  openScenes;

  constructor(demo, view, formats) {
    this.#demo = demo;
    this.#view = view;
    this.#formats = formats;
  }

  /** How many pictures have been drawn, in whichever view. */
  get drawn() {
    return this.#view.drawn + (this.comparison?.drawn ?? 0) + (this.scenes?.drawn ?? 0);
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.#demo.pixels();
  }

  /** Asks for a number format, as the select does: `fx16`, `fx32` or `f32`. */
  setFormat(name) {
    this.#formats.choose(name);
  }

  /** How far a picture of a format may be from the one in f32, in displayed codes. */
  statedError(format) {
    return Demo.statedError(format);
  }

  /**
   * Draws so many pictures, every pass of each whether anything changed or not, and answers the medians in
   * milliseconds. A frame is lighting, encoding and handing over to the canvas, without the geometry: what a
   * picture costs when lights move and the camera stands still.
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
      // The browser gets its turn, as it does between frames.
      await pause();
    }
    const medians = Object.fromEntries(Object.entries(passes).map(([name, times]) => [name, median(times)]));
    return { width: demo.width, height: demo.height, lights: demo.lightsOn, format: demo.format, ...medians };
  }

  /** What a scene costs: see `SceneMeter.measure`. Opens the view of the scenes for it. */
  async measureScene(name, frames, options) {
    return (await this.openScenes()).measure(name, frames, options);
  }
}
