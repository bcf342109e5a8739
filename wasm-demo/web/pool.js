// Draws each picture by several workers, a share by each.
import { Painter } from "./pkg/wasm_demo.js";
import { isTrap, words } from "./failure.js";
import { compile } from "./module.js";
import { built } from "./parts.js";
import { now, Share } from "./share.js";
import { Ended, hire } from "./workers.js";

/** Counts of an account that belong to the whole picture. All others are sums over the shares. */
const COMMON = ["triangles", "lights", "lightsDropped", "leds", "ledCurrent", "ledLimit"];

/** How often workers that end are replaced before a picture is refused. */
const REPLACED = 2;

/** How the refusal of a picture in 32 bits begins, if what draws it is missing. */
export const MISSING = "What draws in 32 bits could not be loaded";

/** The passes of a share. */
const PASSES = /** @type {const} */ (["shadows", "geometry", "lighting", "encode"]);

/** @typedef {Awaited<ReturnType<Share["draw"]>>} Part a share of a picture */
/** @typedef {Part["account"]} Account */
/** @typedef {import("./workers.js").Helper} Helper */
/**
 * A picture in parts: see `Pool.draw`.
 * @typedef {{ isDrawn: boolean, parts: Part[], account: Account, times: Part["times"] & { transfer: number } }} Drawn
 */

/**
 * The module of the painters in 32 bits, once a picture needs it: compiled once for all pools.
 * @type {Promise<WebAssembly.Module> | undefined}
 */
let wide;

export class Pool {
  #module;
  #count;
  /** @type {Helper[]} */
  #helpers = [];
  /** How often workers have been replaced since the last picture. */
  #replaced = 0;
  /** Whether the workers have started that module. */
  #isEquipped = false;
  /**
   * The only share, if there is no worker.
   * @type {Share | undefined}
   */
  #local;
  #opening = Promise.resolve();
  /**
   * For each helper, arrays for pixels to use again.
   * @type {Uint8ClampedArray[][]}
   */
  #spares = [];
  /** Whether the last picture was refused: then the shares may differ in what they have drawn. */
  #isFresh = false;
  /** Resolves with the time when the last picture was drawn or refused, and whether it was refused. */
  #last = Promise.resolve({ end: 0, isRefused: false });

  /**
   * Starts workers.
   *
   * @param {Promise<WebAssembly.Module>} module
   * @param {number} count how many workers; with 0 the page itself draws
   */
  constructor(module, count) {
    this.#module = module;
    this.#count = count;
    this.#start();
  }

  /** How many workers draw a picture; 0 if the page draws it. */
  get size() {
    return this.#helpers.length;
  }

  /**
   * Draws a picture. The result has the `parts` of the picture, in the order of the shares, the
   * `account` of the whole, and `times` in milliseconds: the passes of the share that took longest,
   * of those that drew shadow maps if any did, and all the rest as `transfer`.
   *
   * The next picture may be asked for when `onfree` is called: a worker has then drawn its share,
   * and all workers have drawn theirs of the picture before. So a worker need not wait for the
   * others, and at most two pictures are being drawn.
   * @param {string} job
   * @param {() => void} [onfree]
   * @returns {Promise<Drawn>}
   */
  async draw(job, onfree = () => {}) {
    // Each picture has its own attempts.
    if (this.#replaced > REPLACED) {
      this.#replaced = 0;
      this.#start();
    }
    return this.#attempt(job, onfree);
  }

  /**
   * Draws a picture, again if a worker ends.
   * @param {string} job
   * @param {() => void} onfree
   * @returns {Promise<Drawn>}
   */
  async #attempt(job, onfree) {
    try {
      const drawn = await this.#draw(job, onfree);
      this.#replaced = 0;
      return drawn;
    } catch (error) {
      if (!(error instanceof Ended)) throw error;
      if (this.#replaced > REPLACED) throw `The browser has ended what draws, ${this.#replaced} times: expected memory for ${this.#count} workers. Close other pages, and choose the scene again.`;
      return this.#attempt(job, onfree);
    }
  }

  /**
   * Draws a picture by the workers of now.
   * @param {string} job
   * @param {() => void} onfree
   * @returns {Promise<Drawn>}
   */
  async #draw(job, onfree) {
    await this.#equip([job]);
    const start = now();
    const isFresh = this.#isFresh;
    this.#isFresh = false;
    const before = this.#last;
    const shares = this.#local
      ? [this.#local.draw({ job, isFresh })]
      : this.#helpers.map((helper, share) => this.#ask(helper, share, { job, isFresh }));
    const whole = all(shares);
    this.#last = whole.then(
      () => ({ end: now(), isRefused: false }),
      () => {
        this.#isFresh = true;
        return { end: now(), isRefused: true };
      },
    );
    Promise.all([before, Promise.race(shares).catch(() => {})]).then(onfree);
    const parts = await whole;
    const { end, isRefused } = await before;
    if (isRefused && !isFresh) return this.#draw(job, () => {});
    const span = now() - Math.max(start, end);
    /** @type {(part: Part) => number} */
    const busy = ({ times }) => PASSES.reduce((sum, pass) => sum + (times[pass] ?? 0), 0);
    const casting = parts.filter(({ times }) => times.shadows !== undefined);
    const slowest = (casting.length > 0 ? casting : parts).reduce((one, other) => (busy(other) > busy(one) ? other : one));
    const times = { ...slowest.times, transfer: span - busy(slowest) };
    return { isDrawn: parts.some(({ isDrawn }) => isDrawn), parts, account: total(parts), times };
  }

  /**
   * Takes the arrays of pixels back, to use them again.
   * @param {Part[]} parts
   */
  recycle(parts) {
    parts.forEach(({ pixels }, share) => {
      const spares = this.#spares[share];
      if (pixels && spares) this.#spares[share] = [...spares.slice(0, 1), pixels];
    });
  }

  /**
   * Lights a picture with the needed effects and with all, and compares the two bit for bit.
   * @param {string} job
   */
  async compare(job) {
    await this.#equip([job]);
    /** @type {ReturnType<Share["compare"]>[]} */
    const shares = this.#local
      ? [this.#local.compare({ job })]
      : await all(this.#helpers.map((helper) => helper.ask("compare", { job })));
    /** @type {(name: keyof ReturnType<Share["compare"]>) => number} */
    const sum = (name) => shares.reduce((sum, share) => sum + share[name], 0);
    const [pixels, differing] = [sum("pixels"), sum("differing")];
    const [evaluated, pairs] = [sum("evaluated"), sum("pairs")];
    /** @type {(name: keyof ReturnType<Share["compare"]>) => number} */
    const most = (name) => Math.max(...shares.map((share) => share[name]));
    const times = { lightingMs: most("lightingMs"), everythingMs: most("everythingMs") };
    return { pixels, differing, evaluated, pairs, ...times };
  }

  /**
   * Each worker draws these pictures, one after the other. Returns the longest time.
   * @param {string[]} jobs
   */
  async loop(jobs) {
    await this.#equip(jobs);
    if (this.#local) return this.#local.loop({ jobs });
    return Math.max(...(await all(this.#helpers.map((helper) => helper.ask("loop", { jobs })))));
  }

  /** The memory of all workers' modules in bytes. */
  async memory() {
    await this.#isOpen();
    const sizes = await all(this.#helpers.map((helper) => helper.ask("memory")));
    return sizes.reduce((sum, size) => sum + size, 0);
  }

  /** Ends the workers. */
  end() {
    for (const helper of this.#helpers) helper.end();
  }

  /** Starts workers. */
  #start() {
    this.#helpers = hire(this.#count);
    this.#spares = this.#helpers.map(() => []);
    this.#isEquipped = false;
    for (const helper of this.#helpers) helper.onended = () => this.#replace();
    this.#opening = this.#open();
    // A module that can't be loaded is reported by those who wait for a picture.
    this.#opening.catch(() => {});
  }

  /**
   * Replaces all workers when one has ended: the others may wait for its shadow maps. If too many have ended, the next
   * picture starts others.
   */
  #replace() {
    this.#replaced += 1;
    const ended = new Ended("A worker has ended.");
    for (const helper of this.#helpers) helper.end(ended);
    if (this.#replaced <= REPLACED) return this.#start();
    this.#opening = Promise.reject(ended);
    this.#opening.catch(() => {});
  }

  async #open() {
    const helpers = this.#helpers;
    const compiled = await this.#module;
    const count = helpers.length;
    /** @type {MessagePort[][]} */
    const ports = helpers.map(() => []);
    for (let one = 0; one < count; one += 1) {
      for (let other = one + 1; other < count; other += 1) {
        const { port1, port2 } = new MessageChannel();
        ports[one]?.push(port1);
        ports[other]?.push(port2);
      }
    }
    /** @type {(helper: Helper, share: number) => Promise<void>} */
    const open = (helper, share) => helper.open({ module: compiled, share, count }, ports[share] ?? []);
    try {
      await Promise.all(helpers.map(open));
    } catch (error) {
      // Others have taken their place.
      if (helpers !== this.#helpers) return;
      console.info(`The page draws by itself: ${words(error)}`);
      this.end();
      this.#helpers = [];
    }
    if (this.#helpers.length === 0) this.#local = new Share(0, 1);
  }

  /** Waits for the workers, and for those that replace them meanwhile. */
  async #isOpen() {
    for (let opening; opening !== this.#opening; ) await (opening = this.#opening);
  }

  /**
   * Waits for the workers, and for the painters in 32 bits if any of these jobs needs them.
   * Rejects with a string if those can't be loaded; the next job tries again.
   * @param {string[]} jobs
   */
  async #equip(jobs) {
    await this.#isOpen();
    if (this.#isEquipped || jobs.every((job) => Painter.draws(job))) return;
    await built("wide");
    try {
      wide ??= compile(new URL("pkg/wide_bg.wasm", import.meta.url));
      const order = { module: await wide };
      await (this.#local?.equip(order) ?? all(this.#helpers.map((helper) => helper.ask("equip", order))));
      this.#isEquipped = true;
    } catch (error) {
      wide = undefined;
      if (isTrap(error)) throw error;
      const reason = words(error instanceof Error ? (error.cause ?? error) : error);
      throw (
        `${MISSING} (${reason}). The picture is in 16 bits. ` +
        "Choose the number format again once the connection is up."
      );
    }
  }

  /**
   * @param {Helper} helper
   * @param {number} share
   * @param {{ job: string, isFresh: boolean }} order
   * @returns {Promise<Part>}
   */
  #ask(helper, share, order) {
    const spare = this.#spares[share]?.pop();
    return helper.ask("draw", { ...order, spare }, spare ? [spare.buffer] : []);
  }
}

/**
 * Waits for all answers, also if some are refusals: the workers then wait for the next order.
 * @template T
 * @param {Promise<T>[]} promises
 */
async function all(promises) {
  const answers = await Promise.allSettled(promises);
  for (const answer of answers) if (answer.status === "rejected") throw answer.reason;
  return answers.flatMap((answer) => (answer.status === "fulfilled" ? [answer.value] : []));
}

/**
 * The account of the whole picture.
 * @param {Part[]} parts
 */
function total(parts) {
  const accounts = parts.map(({ account }) => account);
  const whole = { .../** @type {Account} */ (accounts[0]) };
  for (const name of /** @type {(keyof Account)[]} */ (Object.keys(whole))) {
    if (!COMMON.includes(name)) whole[name] = accounts.reduce((sum, account) => sum + account[name], 0);
  }
  return whole;
}
