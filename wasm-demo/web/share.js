// A share of each picture: every n-th stripe of 16 rows. It is drawn in a worker, or on the page if
// the browser has no workers.
import { Painter } from "./pkg/wasm_demo.js";
import { plain } from "./plain.js";
import { load } from "./support.js";

/** The time in milliseconds. The date is precise enough if the browser has no clock. */
export const now = () => globalThis.performance?.now() ?? Date.now();

/** @typedef {import("./pkg/wasm_demo.js").AccountState} AccountState */
/**
 * The shadow maps that a share sends with a picture, or why there are none.
 * @typedef {{ maps?: { light: number, depths: Uint32Array }[], refusal?: unknown }} Letter
 */

export class Share {
  /** Which share, of how many. */
  #place;
  /** The painter of the last picture. */
  #painter;
  /** The painter of pictures in 16 bits. */
  #own;
  /**
   * The painter of pictures in 32 bits, and its memory, once `equip` has started its module.
   * @type {{ painter: Painter, memory: WebAssembly.Memory } | undefined}
   */
  #wide;
  #ports;
  /** For each other share the shadow maps that it has sent, one list for each picture. */
  /** @type {Letter[][]} */
  #mail;
  /** Called when mail arrives. */
  #wake = /** @type {() => void} */ (() => {});
  /**
   * Arrays of shadow maps to use again.
   * @type {Uint32Array[]}
   */
  #spares = [];

  /**
   * @param {number} share from 0
   * @param {number} count how many shares there are
   * @param {MessagePort[]} ports to each other share
   */
  constructor(share, count, ports = []) {
    this.#place = /** @type {const} */ ([share, count]);
    this.#own = this.#painter = new Painter(share, count);
    this.#ports = ports;
    this.#mail = ports.map(() => []);
    ports.forEach((port, from) => {
      port.onmessage = ({ data }) => {
        this.#mail[from].push(data);
        this.#wake();
      };
    });
  }

  /** The memory of the painters in 32 bits in bytes. */
  get memory() {
    return this.#wide?.memory.buffer.byteLength ?? 0;
  }

  /**
   * Starts the module of the painters in 32 bits.
   * @param {{ module: WebAssembly.Module }} order
   */
  async equip({ module }) {
    if (this.#wide) return;
    /** @type {typeof import("./pkg/wide.js")} */
    const { initSync, Painter } = await load("pkg/wide.js");
    const { memory } = initSync({ module });
    this.#wide = { painter: new Painter(...this.#place), memory };
  }

  /**
   * Returns the painter of a job. The other one forgets its pictures, which take memory.
   * @param {string} job
   */
  #painterOf(job) {
    const painter = Painter.draws(job) ? this.#own : this.#wide?.painter;
    if (!painter) throw new Error(`job = "${job}": expected one in 16 bits, or \`equip\` before it`);
    if (painter !== this.#painter) this.#painter.forget();
    return (this.#painter = painter);
  }

  /**
   * Draws the stripes of a picture. The shares pass shadow maps on to one another while each draws
   * its geometry, so that each map is drawn once.
   *
   * @param {object} order
   * @param {string} order.job of the stage
   * @param {boolean} [order.isFresh] whether nothing is kept of earlier pictures
   * @param {Uint8ClampedArray} [order.spare] an array for the pixels
   */
  async draw({ job, isFresh = false, spare }) {
    const painter = this.#painterOf(job);
    if (isFresh) painter.forget();
    painter.take(job);
    const isShared = painter.castsShadows && this.#ports.length > 0;
    this.#send(() => painter.drawShadows(), isShared);
    painter.drawGeometry();
    if (isShared) await this.#receive();
    const isDrawn = painter.drawLight();
    return {
      isDrawn,
      pixels: isDrawn ? painter.pixels(spare) : undefined,
      marks: isDrawn ? painter.edgeMarks() : undefined,
      counts: painter.counts(),
      // There is one, because `drawLight` has made it.
      account: /** @type {AccountState} */ (painter.account()),
      times: plain(painter.times()),
    };
  }

  /**
   * Draws pictures one after the other. Returns the time in milliseconds.
   * @param {{ jobs: string[] }} order
   */
  async loop({ jobs }) {
    const start = now();
    for (const job of jobs) await this.draw({ job });
    return now() - start;
  }

  /** @param {{ job: string }} order */
  compare({ job }) {
    return plain(this.#painterOf(job).compare(job));
  }

  /**
   * @param {() => Uint32Array} draw returns the lights whose shadow maps it has drawn
   * @param {boolean} isShared
   */
  #send(draw, isShared) {
    let lights;
    try {
      lights = draw();
    } catch (refusal) {
      // The others wait for an answer.
      if (isShared) for (const port of this.#ports) port.postMessage({ refusal });
      throw refusal;
    }
    if (!isShared) return;
    for (const port of this.#ports) {
      const maps = Array.from(lights, (light) => ({ light, depths: this.#painter.shadowMap(light, this.#spares.pop()) }));
      port.postMessage({ maps }, maps.map(({ depths }) => depths.buffer));
    }
  }

  async #receive() {
    while (this.#mail.some((pictures) => pictures.length === 0)) {
      await new Promise((resolve) => (this.#wake = () => resolve(undefined)));
    }
    const letters = this.#mail.flatMap((pictures) => pictures.shift() ?? []);
    for (const { maps = [], refusal } of letters) {
      if (refusal !== undefined) throw refusal;
      for (const { light, depths } of maps) {
        this.#painter.takeShadowMap(light, depths);
        this.#spares.push(depths);
      }
    }
    // As many as this share sends with the next picture, if as many lights move.
    this.#spares.length = Math.min(this.#spares.length, 16);
  }
}

/**
 * Draws a small picture of a scene: RGBA.
 * @param {{ scene: string, width: number, height: number }} order
 */
export const thumbnail = ({ scene, width, height }) => Painter.thumbnail(scene, width, height);
