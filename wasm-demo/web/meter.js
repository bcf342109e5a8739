// Interface for tests and measurements: `window.luminaire`.
import { Stage } from "./pkg/wasm_demo.js";
import { median } from "./numbers.js";
import { Pool } from "./pool.js";
import { Screen } from "./screen.js";
import { now } from "./share.js";
import { cores } from "./workers.js";

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

/** The passes of a share of a picture. */
const SHARED = /** @type {const} */ (["geometry", "shadows", "lighting", "encode"]);

const PASSES = /** @type {const} */ ([...SHARED, "transfer", "show", "frame"]);

/** @typedef {typeof PASSES[number]} Pass */

/**
 * @typedef {object} Options
 * @property {number} [width] of the picture in pixels
 * @property {number} [height]
 * @property {string} [format] `f32`, `fx32` or `fx16`
 * @property {number} [spots] how many there are above the turntable
 * @property {number} [shadows] the side of their shadow maps in texels, above the turntable
 * @property {string[]} [with] effects to put in, such as `haze`
 * @property {string[]} [without] effects to leave out, such as `specular`
 * @property {number} [workers] how many draw; with 0 the page draws by itself
 * @property {boolean} [everything] whether all effects are evaluated, needed or not
 */

export class Meter {
  #stage;
  #module;
  #memory;

  /**
   * The comparison view; undefined until it is opened.
   * @type {import("./comparison-view.js").ComparisonView | undefined}
   */
  comparison;

  /**
   * The view of the chip; undefined until it is opened.
   * @type {import("./chip-view.js").ChipView | undefined}
   */
  chip;

  /**
   * The museum; undefined until it is opened.
   * @type {import("./museum-view.js").MuseumView | undefined}
   */
  museum;

  /**
   * The class; undefined until it is opened.
   * @type {import("./class-view.js").ClassView | undefined}
   */
  class;

  /**
   * @param {Stage} stage
   * @param {import("./stage-page.js").StagePage} page
   * @param {WebAssembly.Module} module
   * @param {WebAssembly.Memory} memory of the page's own instance
   */
  constructor(stage, page, module, memory) {
    this.#stage = stage;
    this.page = page;
    this.#module = module;
    this.#memory = memory;
  }

  /** The memory of the page's module and of those of its workers, in bytes. */
  async memory() {
    return this.#memory.buffer.byteLength + (await this.page.memory());
  }

  /** Number of pictures that were drawn, in all views. */
  get drawn() {
    return this.page.drawn + (this.comparison?.drawn ?? 0) + (this.museum?.drawn ?? 0) + (this.class?.drawn ?? 0);
  }

  /** The name of the scene. */
  get scene() {
    return this.#stage.scene;
  }

  /** The current number format. */
  get format() {
    return this.#stage.get("format");
  }

  /**
   * Requests a number format, as the select does: `fx16`, `fx32` or `f32`.
   * @param {string} name
   */
  setFormat(name) {
    this.page.setFormat(name);
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.page.pixels();
  }

  /** Draws what has changed, now. Resolves when it is shown. */
  redraw() {
    return this.page.redraw();
  }

  /**
   * Draws `frames` frames of a scene while its lights move, on a stage and workers of its own. Returns the
   * medians of each pass in milliseconds: with the camera at rest, and with a turning camera, so
   * that the geometry is redrawn and every pixel re-lit. A frame is everything from setting the
   * lights until the canvas shows it. At rest, if nothing moves, nothing is drawn, and the times are
   * `null`. `leastFrameMs` is the shortest frame: the time on a machine without other load.
   *
   * @param {string} name
   * @param {number} frames
   * @param {Options} [options]
   */
  async measureScene(name, frames, options = {}) {
    const { format = "f32", workers = cores() } = options;
    const stage = opened(name, options);
    const { width, height } = stage;
    const pool = new Pool(Promise.resolve(this.#module), workers);
    const screen = hidden();
    const cameraAtRest = await run(stage, pool, screen, frames, () => {});
    const cameraMoving = await run(stage, pool, screen, frames, () => stage.orbit(TURN, 0));
    const lights = stage.lightCount;
    stage.free();
    pool.end();
    return { scene: name, width, height, format, workers, lights, cameraAtRest, cameraMoving };
  }

  /**
   * Compares workers that share pictures with workers that know nothing of one another: `frames`
   * pictures of a scene with a moving camera are drawn by `workers` workers together, and shown, and
   * then by each of as many workers in a loop of its own. Returns the pictures a second of both, the
   * better of `rounds` rounds.
   *
   * @param {string} name
   * @param {number} frames
   * @param {number} rounds
   * @param {Options} [options]
   */
  async measureCores(name, frames, rounds, options = {}) {
    const { workers = cores() } = options;
    const stage = opened(name, options);
    /** @type {(frame: number) => string} */
    const order = (frame) => {
      stage.seek(STEP * frame, 0);
      stage.orbit(TURN, 0);
      return stage.job();
    };
    const jobs = Array.from({ length: WARM_UP + frames }, (_, frame) => order(frame));
    const module = Promise.resolve(this.#module);
    const pool = new Pool(module, workers);
    const loops = Array.from({ length: workers }, () => new Pool(module, 1));
    let [together, apart] = [0, 0];
    for (let round = 0; round < rounds; round += 1) {
      together = Math.max(together, (1000 * frames) / (await inTurn(stage, pool, jobs)));
      await Promise.all(loops.map((loop) => loop.loop(jobs.slice(0, WARM_UP))));
      const times = await Promise.all(loops.map((loop) => loop.loop(jobs.slice(WARM_UP))));
      apart = Math.max(apart, (1000 * frames * workers) / Math.max(...times));
    }
    for (const each of [pool, ...loops]) each.end();
    stage.free();
    return { workers, togetherPerSecond: together, apartPerSecond: apart, share: together / apart };
  }
}

// What the stage tells of itself: see `StagePage`.
for (const name of /** @type {const} */ (["account", "difference", "isDrawing", "price", "times"])) {
  Object.defineProperty(Meter.prototype, name, {
    get() {
      return this.page[name];
    },
  });
}

/**
 * Opens a scene on a stage of its own.
 * @param {string} name
 * @param {Options} options
 */
function opened(name, options) {
  const { width = 960, height = 540, format = "f32", everything = false } = options;
  const { spots, shadows, with: added = [], without = [] } = options;
  const stage = new Stage(width, height);
  if (name === "turntable") stage.openTurntable(spots ?? 8, shadows);
  else stage.open(name);
  stage.set("format", format);
  stage.set("all", everything);
  for (const effect of added) stage.setEffect(effect, true);
  for (const effect of without) stage.setEffect(effect, false);
  return stage;
}

/** A screen that is not on the page. */
const hidden = () => new Screen(document.createElement("canvas"), document.createElement("canvas"));

/**
 * Draws pictures as an animation does: the next one is begun when a worker is free. Returns the time
 * in milliseconds, without that of the first pictures.
 * @param {Stage} stage
 * @param {Pool} pool
 * @param {string[]} jobs
 */
async function inTurn(stage, pool, jobs) {
  const { width, height } = stage;
  const screen = hidden();
  /** @type {(job: string) => { drawing: ReturnType<Pool["draw"]>, free: Promise<void> }} */
  const begin = (job) => {
    /** @type {() => void} */
    let onfree = () => {};
    const free = /** @type {Promise<void>} */ (new Promise((resolve) => (onfree = resolve)));
    return { drawing: pool.draw(job, onfree), free };
  };
  let start = now();
  let picture = begin(jobs[0]);
  for (let next = 1; next <= jobs.length; next += 1) {
    const { drawing, free } = picture;
    // A refused picture does not call `onfree`.
    await Promise.race([free, drawing]);
    if (next < jobs.length) picture = begin(jobs[next]);
    const { parts } = await drawing;
    if (next === WARM_UP) start = now();
    screen.gather(parts, { width, height });
    pool.recycle(parts);
    screen.show();
  }
  return now() - start;
}

/**
 * @param {Stage} stage
 * @param {Pool} pool
 * @param {Screen} screen
 * @param {number} frames
 * @param {() => void} move
 */
async function run(stage, pool, screen, frames, move) {
  const { width, height } = stage;
  const times = /** @type {Record<Pass, number[]>} */ (Object.fromEntries(PASSES.map((pass) => [pass, /** @type {number[]} */ ([])])));
  for (let frame = -WARM_UP; frame < frames; frame += 1) {
    const start = now();
    stage.seek(STEP * (frame + WARM_UP), 0);
    move();
    const { isDrawn, parts, times: passed } = await pool.draw(stage.job());
    if (isDrawn) {
      screen.gather(parts, { width, height });
      pool.recycle(parts);
      const gathered = now();
      screen.show();
      const end = now();
      const busy = SHARED.reduce((sum, pass) => sum + (passed[pass] ?? 0), 0);
      const rest = { transfer: gathered - start - busy, show: end - gathered, frame: end - start };
      /** @type {Partial<Record<Pass, number>>} */
      const measured = { ...passed, ...rest };
      for (const pass of PASSES) if (frame >= 0 && measured[pass] !== undefined) times[pass].push(measured[pass]);
    }
    // Yields to the browser, as between frames.
    await pause();
  }
  if (times.frame.length === 0) return null;
  /** @type {(pass: Pass) => [string, number | null]} */
  const middle = (pass) => [`${pass}Ms`, times[pass].length > 0 ? median(times[pass]) : null];
  return { ...Object.fromEntries(PASSES.map(middle)), leastFrameMs: Math.min(...times.frame) };
}
