// How much a number format changes the picture that is shown, in one sentence that is measured.
import { Divided } from "./pkg/wasm_demo.js";
import { apart } from "./apart.js";
import { element, fetchText } from "./elements.js";
import { words } from "./failure.js";
import { built, isBuilt } from "./parts.js";
import { Pool } from "./pool.js";

/** Time after a change until the visitor has probably paused, in milliseconds. */
const PAUSE = 600;

/** Longest time that a busy browser lets a measurement wait, in milliseconds. */
const PATIENCE = 5000;

/** The formats in fixed point, in words. */
const NAMES = /** @type {const} */ ({ fx16: "16 bits", fx32: "32 bits" });

/**
 * @typedef {Record<"light" | "colours" | "highlight" | "gobo" | "shadow" | "clip" | "hue" | "haze", number>
 *   & { displays: Record<string, Record<"nearest" | "dithered", number>> }} Work instructions on a chip
 */

export class Verdict {
  #stage;
  #module;
  #shown;
  /** @type {number | undefined} */
  #timer;
  /**
   * The largest difference that the sentence states.
   * @type {number | undefined}
   */
  #most;
  /** The jobs of the last measurement. */
  #measured = "";
  /**
   * The instructions of the parts of a picture, by the format, once they are known.
   * @type {Promise<Record<string, Work>> | undefined}
   */
  #work;

  /** Called with the format that the picture is to be compared with, to show where they differ. */
  onwhere = /** @type {(format: string) => void} */ (() => {});

  /** Called with that format, to divide the picture between both, and with none, to make it whole. */
  onbeside = /** @type {(format?: string) => void} */ (() => {});

  /** Called when the picture has been measured. */
  onmeasured = () => {};

  /** Called when what draws in 32 bits has been waited for and is built. */
  onbuilt = () => {};

  /**
   * @param {import("./pkg/wasm_demo.js").Stage} stage
   * @param {WebAssembly.Module} module
   * @param {(job: string) => Uint8ClampedArray | undefined} shown the pixels of a job, if the page shows it
   */
  constructor(stage, module, shown) {
    this.#stage = stage;
    this.#module = module;
    this.#shown = shown;
    element("verdict-where").addEventListener("click", () => this.onwhere(this.#other));
    element("beside").addEventListener("click", () => this.onbeside(this.#isDivided ? undefined : this.#other));
  }

  /** The format that the picture is to be compared with. */
  get #other() {
    return this.#stage.get("format") === "f32" ? "fx16" : "f32";
  }

  get #isDivided() {
    return Boolean(this.#stage.get("with"));
  }

  /** Shows what can be done after the sentence: to divide the picture, and then to find the difference. */
  show() {
    element("beside").hidden = this.#most === undefined;
    element("beside").textContent = this.#isDivided ? "Show whole" : "Compare";
    element("verdict-where").hidden = !this.#most || !this.#isDivided || this.#stage.get("difference") === true;
  }

  /** The format that is judged: that of the picture, or 16 bits for a picture in floats. */
  get #format() {
    return this.#stage.get("format") === "fx32" ? "fx32" : "fx16";
  }

  /** Measures once the visitor pauses, if the picture has changed. */
  later() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#measure(), PAUSE);
  }

  /** Ends what has not been measured. */
  stop() {
    clearTimeout(this.#timer);
  }

  async #measure() {
    const stage = this.#stage;
    const format = this.#format;
    const jobs = [format, "f32"].map((name) => stage.jobIn(name));
    const display = this.#display;
    const asked = jobs.join();
    if (asked === this.#measured) return;
    this.#measured = asked;
    /** @type {Pool | undefined} */
    let pool;
    try {
      await this.#wide((text) => asked === this.#measured && this.#tell(text));
      if (asked !== this.#measured) return;
      pool = new Pool(Promise.resolve(this.#module), 1);
      const shown = jobs.map((job) => this.#shown(job));
      const pictures = [];
      /** @type {import("./pool.js").Account | undefined} */
      let account;
      for (const [i, job] of jobs.entries()) {
        // Every format has the same account. That of a picture that is shown may be of the tiles that changed.
        const drawn = shown[i] && (account || i === 0) ? undefined : await pool.draw(job);
        account ??= drawn?.account;
        pictures.push(bytes(drawn ? drawn.parts[0].pixels : shown[i]));
      }
      const divided = new Divided(pictures[0], pictures[1]);
      const { differing, beyond, largest: most } = divided;
      divided.free();
      const difference = apart({ pixels: pictures[0].length / 4, differing, beyond, most }, "32-bit floats");
      const price = await this.#price(format, { account, pixels: pictures[0].length / 4, ...display });
      // A later picture may have been measured in the meantime.
      if (asked !== this.#measured) return;
      this.#tell(`${NAMES[format]}: ${difference}; ${price}.`, most);
      this.onmeasured();
    } catch (refusal) {
      if (asked !== this.#measured) return;
      this.#measured = "";
      this.#work = undefined;
      const drawn = isBuilt("wide") ? "" : " The picture is drawn in 16 bits.";
      this.#tell(`${NAMES[format]}: not measured: ${words(refusal)}${drawn}`);
    } finally {
      pool?.end();
    }
  }

  /**
   * Waits until what draws in 32 bits is built, and until the browser is idle: that module is as large as
   * the module of the first picture.
   * @param {(text: string) => void} tell
   */
  async #wide(tell) {
    if (!isBuilt("wide")) {
      await built("wide", tell);
      this.onbuilt();
    }
    // Safari has no such call.
    await new Promise((resolve) => ("requestIdleCallback" in window ? requestIdleCallback(resolve, { timeout: PATIENCE }) : setTimeout(resolve)));
  }

  /**
   * @param {string} text
   * @param {number} [most] the largest difference, once it is measured
   */
  #tell(text, most) {
    element("verdict-text").textContent = text;
    this.#most = most;
    this.show();
  }

  /** What the picture is encoded for. */
  get #display() {
    const isDithered = this.#stage.switches().some(({ effect, on }) => effect === "dither" && on);
    return { name: String(this.#stage.get("display")), isDithered, keepsHue: this.#stage.get("tone") === true };
  }

  /**
   * What share of the instructions in floats this picture takes.
   * @param {string} format
   * @param {{ account: import("./pool.js").Account | undefined, pixels: number, name: string, isDithered: boolean, keepsHue: boolean }} picture
   */
  async #price(format, { account, pixels, name, isDithered, keepsHue }) {
    this.#work ??= fetchText("chips.json").then((text) => JSON.parse(text).work);
    const work = await this.#work;
    if (!account) throw new Error("the picture has no account");
    const { evaluated, evaluatedShining, evaluatedThroughGobos, evaluatedInShadows, evaluatedInAir } = account;
    const [own, floats] = [format, "f32"].map((of) => {
      const { light, colours, highlight, gobo, shadow, clip, hue, haze, displays } = work[of];
      const code = displays[name][isDithered ? "dithered" : "nearest"];
      const filters = evaluatedThroughGobos * gobo + evaluatedInShadows * shadow;
      const lights = evaluated * (light + colours) + evaluatedShining * highlight + filters;
      return lights + evaluatedInAir * haze + pixels * (code + (keepsHue ? hue : clip));
    });
    const haze = evaluatedInAir > 0 ? "; haze in floats" : "";
    return `${Math.round((100 * own) / floats)} % of the best floats' instructions on an M0${haze}`;
  }
}

/**
 * The bytes of a picture.
 * @param {Uint8ClampedArray | undefined} pixels
 */
function bytes(pixels) {
  if (!pixels) throw new Error("the picture is empty");
  return new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.length);
}
