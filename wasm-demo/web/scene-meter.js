// Measures the cost of a scene in this browser, frame by frame.
import { median } from "./numbers.js";

const pause = () => new Promise((resolve) => setTimeout(resolve));

/**
 * Frames drawn before the measured ones: the browser has not optimised the code of the first frames
 * yet.
 */
const WARM_UP = 8;

/** Scene time between frames, in seconds. */
const STEP = 1 / 30;

/** Yaw of the camera between frames, where it moves, in radians. */
const TURN = 0.004;

const PASSES = ["geometryMs", "shadowsMs", "lightingMs", "encodeMs", "showMs", "frameMs"];

export class SceneMeter {
  #scenes;

  constructor(scenes) {
    this.#scenes = scenes;
  }

  /**
   * Draws `frames` frames of a scene while its lights move. Returns the medians of each pass in
   * milliseconds: with the camera at rest, and with a turning camera, so that the geometry is
   * redrawn and every pixel re-lit. A frame is everything from setting the lights until the canvas
   * shows it. At rest, if nothing moves, nothing is drawn, and the times are `null`. `leastFrameMs`
   * is the shortest frame: the time on a machine without other load.
   *
   * @param {string} name
   * @param {number} frames
   * @param {object} [options]
   * @param {number} [options.width] of the picture in pixels
   * @param {number} [options.height]
   * @param {string} [options.format] `f32`, `fx32` or `fx16`
   * @param {number} [options.spots] how many there are above the turntable
   * @param {number} [options.shadows] the side of their shadow maps in texels, above the turntable
   * @param {string[]} [options.with] effects to put in, such as `haze`
   * @param {string[]} [options.without] effects to leave out, such as `specular`
   * @param {boolean} [options.everything] whether all effects are evaluated, needed or not
   */
  async measure(name, frames, options = {}) {
    const { width = 960, height = 540, format = "f32", everything = false } = options;
    const { spots, shadows, with: added = [], without = [] } = options;
    const scenes = this.#scenes;
    if (name === "turntable") scenes.openTurntable(spots ?? 8, shadows, width, height);
    else scenes.open(name, width, height);
    scenes.setFormat(format);
    scenes.setEverything(everything);
    for (const effect of added) scenes.setEffect(effect, true);
    for (const effect of without) scenes.setEffect(effect, false);
    const cameraAtRest = await this.#run(frames, () => {});
    const cameraMoving = await this.#run(frames, () => scenes.orbit(TURN, 0));
    const account = scenes.account();
    const { lights } = account;
    account.free();
    return { scene: name, width, height, format, lights, cameraAtRest, cameraMoving };
  }

  async #run(frames, move) {
    const times = Object.fromEntries(PASSES.map((pass) => [pass, []]));
    for (let frame = -WARM_UP; frame < frames; frame += 1) {
      this.#scenes.seek(STEP * (frame + WARM_UP), 0);
      move();
      if (this.#scenes.draw() && frame >= 0) {
        for (const pass of PASSES) times[pass].push(this.#scenes[pass]);
      }
      // Yields to the browser, as between frames.
      await pause();
    }
    if (times.frameMs.length === 0) return null;
    const middle = (pass) => {
      const known = times[pass].filter((time) => time !== undefined);
      return known.length > 0 ? median(known) : null;
    };
    const medians = Object.fromEntries(PASSES.map((pass) => [pass, middle(pass)]));
    return { ...medians, leastFrameMs: Math.min(...times.frameMs) };
  }
}
