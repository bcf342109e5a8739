// Draws each picture by several workers, a share by each.
import { now, Share } from "./share.js";
import { hire } from "./workers.js";

/** Counts of an account that belong to the whole picture. All others are sums over the shares. */
const COMMON = ["triangles", "lights", "lightsDropped"];

/** The passes of a share. */
const PASSES = ["shadows", "geometry", "lighting", "encode"];

export class Pool {
  #helpers;
  /** The only share, if there is no worker. */
  #local;
  #opening;
  /** For each helper, arrays for pixels to use again. */
  #spares;
  #isFresh = false;

  /**
   * Starts workers.
   *
   * @param {Promise<WebAssembly.Module>} module
   * @param {number} count how many workers; with 0 the page itself draws
   */
  constructor(module, count) {
    this.#helpers = hire(count);
    this.#spares = this.#helpers.map(() => []);
    this.#opening = this.#open(module);
    // A module that can't be loaded is reported by those who wait for a picture.
    this.#opening.catch(() => {});
  }

  /** How many workers draw a picture; 0 if the page draws it. */
  get size() {
    return this.#helpers.length;
  }

  /**
   * Draws a picture. The result has the `parts` of the picture, in the order of the shares, the
   * `account` of the whole, and `times` in milliseconds: the passes of the share that took longest,
   * of those that drew shadow maps if any did, and all the rest as `transfer`. Only one picture may
   * be asked for at a time.
   */
  async draw(job) {
    await this.#opening;
    const start = now();
    const isFresh = this.#isFresh;
    this.#isFresh = true;
    const parts = this.#local
      ? [await this.#local.draw({ job, isFresh })]
      : await all(this.#helpers.map((helper, share) => this.#ask(helper, share, { job, isFresh })));
    this.#isFresh = false;
    const span = now() - start;
    const busy = ({ times }) => PASSES.reduce((sum, pass) => sum + (times[pass] ?? 0), 0);
    const casting = parts.filter(({ times }) => times.shadows !== undefined);
    const slowest = (casting.length > 0 ? casting : parts).reduce((one, other) => (busy(other) > busy(one) ? other : one));
    const times = { ...slowest.times, transfer: span - busy(slowest) };
    return { isDrawn: parts.some(({ isDrawn }) => isDrawn), parts, account: total(parts), times };
  }

  /** Takes the arrays of pixels back, to use them again. */
  recycle(parts) {
    parts.forEach(({ pixels }, share) => {
      if (pixels && this.#spares[share]) this.#spares[share] = [...this.#spares[share].slice(0, 1), pixels];
    });
  }

  /** Lights a picture with the needed effects and with all, and compares the two bit for bit. */
  async compare(job) {
    await this.#opening;
    const shares = this.#local
      ? [this.#local.compare({ job })]
      : await all(this.#helpers.map((helper) => helper.ask("compare", { job })));
    const sum = (name) => shares.reduce((sum, share) => sum + share[name], 0);
    const sums = Object.fromEntries(["pixels", "differing", "evaluated", "pairs"].map((name) => [name, sum(name)]));
    const most = (name) => Math.max(...shares.map((share) => share[name]));
    return { ...sums, lightingMs: most("lightingMs"), everythingMs: most("everythingMs") };
  }

  /** Each worker draws these pictures, one after the other. Returns the longest time. */
  async loop(jobs) {
    await this.#opening;
    if (this.#local) return this.#local.loop({ jobs });
    return Math.max(...(await all(this.#helpers.map((helper) => helper.ask("loop", { jobs })))));
  }

  /** The memory of all workers' modules in bytes. */
  async memory() {
    await this.#opening;
    const sizes = await all(this.#helpers.map((helper) => helper.ask("memory")));
    return sizes.reduce((sum, size) => sum + size, 0);
  }

  /** Ends the workers. */
  end() {
    for (const helper of this.#helpers) helper.end();
  }

  async #open(module) {
    const compiled = await module;
    const count = this.#helpers.length;
    const ports = this.#helpers.map(() => []);
    for (let one = 0; one < count; one += 1) {
      for (let other = one + 1; other < count; other += 1) {
        const { port1, port2 } = new MessageChannel();
        ports[one].push(port1);
        ports[other].push(port2);
      }
    }
    const open = (helper, share) =>
      helper.ask("open", { module: compiled, share, count, ports: ports[share] }, ports[share]);
    try {
      await Promise.all(this.#helpers.map(open));
    } catch (error) {
      console.info(`The page draws by itself: ${error.message ?? error}`);
      this.end();
      this.#helpers = [];
    }
    if (this.#helpers.length === 0) this.#local = new Share(0, 1);
  }

  #ask(helper, share, order) {
    const spare = this.#spares[share].pop();
    return helper.ask("draw", { ...order, spare }, spare ? [spare.buffer] : []);
  }
}

/** Waits for all answers, also if some are refusals: the workers then wait for the next order. */
async function all(promises) {
  const answers = await Promise.allSettled(promises);
  const failed = answers.find(({ status }) => status === "rejected");
  if (failed) throw failed.reason;
  return answers.map(({ value }) => value);
}

function total(parts) {
  const [first, ...rest] = parts.map(({ account }) => account);
  const sum = (name) => (COMMON.includes(name) ? first[name] : rest.reduce((sum, account) => sum + account[name], first[name]));
  return Object.fromEntries(Object.keys(first).map((name) => [name, sum(name)]));
}
