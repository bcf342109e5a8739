// Interface for tests and measurements: `window.luminaire`.
import { Stage } from "./pkg/wasm_demo.js";
import { median } from "./numbers.js";
import { plain } from "./plain.js";

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

const PASSES = ["geometry", "shadows", "lighting", "encode", "show", "frame"];

export class Meter {
  #stage;
  #page;

  /** The comparison view; undefined until it is opened. */
  comparison;
  /** The view of the chip; undefined until it is opened. */
  chip;

  constructor(stage, page) {
    this.#stage = stage;
    this.#page = page;
  }

  /** Number of pictures that were drawn, in all views. */
  get drawn() {
    return this.#page.drawn + (this.comparison?.drawn ?? 0);
  }

  /** The name of the scene. */
  get scene() {
    return this.#stage.scene;
  }

  /** The current number format. */
  get format() {
    return this.#stage.format;
  }

  /** The costs of the last picture's light: a plain object. */
  get account() {
    return plain(this.#stage.account());
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.#stage.pixels();
  }

  /** Requests a number format, as the select does: `fx16`, `fx32` or `f32`. */
  setFormat(name) {
    this.#page.setFormat(name);
  }

  /**
   * Returns the largest difference between a picture in a format and one in f32, in displayed
   * codes.
   */
  statedError(format) {
    return Stage.statedError(format);
  }

  /** Draws what has changed, now. */
  redraw() {
    this.#page.redraw();
  }

  /**
   * Lights the picture with the needed effects, and again with all effects; compares both bit for
   * bit.
   */
  compare() {
    return plain(this.#stage.compare());
  }

  /**
   * Draws `frames` frames of a scene while its lights move, on a stage of its own. Returns the
   * medians of each pass in milliseconds: with the camera at rest, and with a turning camera, so
   * that the geometry is redrawn and every pixel re-lit. A frame is everything from setting the
   * lights until the canvas shows it. At rest, if nothing moves, nothing is drawn, and the times are
   * `null`. `leastFrameMs` is the shortest frame: the time on a machine without other load.
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
  async measureScene(name, frames, options = {}) {
    const { width = 960, height = 540, format = "f32", everything = false } = options;
    const { spots, shadows, with: added = [], without = [] } = options;
    const canvas = () => document.createElement("canvas");
    const stage = new Stage(canvas(), canvas(), width, height);
    if (name === "turntable") stage.openTurntable(spots ?? 8, shadows);
    else stage.open(name);
    stage.setFormat(format);
    stage.setEverything(everything);
    for (const effect of added) stage.setEffect(effect, true);
    for (const effect of without) stage.setEffect(effect, false);
    const cameraAtRest = await run(stage, frames, () => {});
    const cameraMoving = await run(stage, frames, () => stage.orbit(TURN, 0));
    const { lights } = plain(stage.account());
    stage.free();
    return { scene: name, width, height, format, lights, cameraAtRest, cameraMoving };
  }
}

async function run(stage, frames, move) {
  const times = Object.fromEntries(PASSES.map((pass) => [pass, []]));
  for (let frame = -WARM_UP; frame < frames; frame += 1) {
    stage.seek(STEP * (frame + WARM_UP), 0);
    move();
    if (stage.draw() && frame >= 0) {
      const measured = plain(stage.times());
      for (const pass of PASSES) if (measured[pass] !== undefined) times[pass].push(measured[pass]);
    }
    // Yields to the browser, as between frames.
    await pause();
  }
  if (times.frame.length === 0) return null;
  const middle = (pass) => [`${pass}Ms`, times[pass].length > 0 ? median(times[pass]) : null];
  return { ...Object.fromEntries(PASSES.map(middle)), leastFrameMs: Math.min(...times.frame) };
}
