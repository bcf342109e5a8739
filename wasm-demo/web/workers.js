// Workers of the page, each with an instance of the module.
import { words } from "./failure.js";

/** Most workers that are started: with more, the stripes of a picture are too few. */
const MOST = 8;

/** How many workers draw a picture, unless the address asks for another number. */
export const cores = () => Math.max(1, Math.min(navigator.hardwareConcurrency ?? 1, MOST));

/**
 * A message of a worker: the result of the question of that number, or why there is none.
 * @typedef {{ number: number, result?: unknown, refusal?: string, error?: string, isTrap?: boolean, panic?: string }} Answer
 */

/** Why a question to a worker that has ended has no answer. */
export class Ended extends Error {}

/** How many workers have been started. */
let started = 0;

export class Helper {
  #worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  /**
   * The questions that are not answered yet, by their number.
   * @type {Map<number, { resolve: (result: any) => void, reject: (cause: unknown) => void }>}
   */
  #asked = new Map();
  #number = 0;
  /** @type {Error | undefined} */
  #broken;
  /** The name of what the worker holds while it lives, as no other page does. */
  #lock = `worker ${performance.timeOrigin} ${Math.random()} ${(started += 1)}`;

  /** Called when the worker has ended by itself, as for want of memory. */
  onended = () => {};

  constructor() {
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#break(new Error(`A worker could not be used: ${event.message ?? "its script was not loaded"}`));
    };
  }

  /**
   * Asks the worker. Rejects with a string what the module refuses.
   * @param {string} act
   * @param {object} [order]
   * @param {Transferable[]} [transferred]
   * @returns {Promise<any>}
   */
  ask(act, order, transferred = []) {
    if (this.#broken) return Promise.reject(this.#broken);
    return new Promise((resolve, reject) => {
      const number = (this.#number += 1);
      this.#asked.set(number, { resolve, reject });
      this.#worker.postMessage({ number, act, ...order }, transferred);
    });
  }

  /**
   * Gives the worker its share of the pictures.
   * @param {object} order
   * @param {MessagePort[]} ports
   */
  async open(order, ports) {
    const isHeld = this.ask("hold", { lock: this.#lock });
    // It is granted when the worker has ended, as it may for want of memory while it opens.
    const watch = () => navigator.locks?.request(this.#lock, () => this.#broken ?? this.onended());
    isHeld.then(watch).catch(() => {});
    await Promise.all([isHeld, this.ask("open", { ...order, ports }, ports)]);
  }

  /**
   * Ends the worker. What it was asked for stays unanswered unless there is a reason to reject it.
   * @param {Error} [why]
   */
  end(why) {
    this.#worker.terminate();
    if (why) this.#break(why);
    this.#broken ??= new Error("A worker was asked after its end.");
  }

  /** @param {Answer} answer */
  #take({ number, result, refusal, error, isTrap, panic }) {
    if (panic !== undefined) {
      window.dispatchEvent(new CustomEvent("luminaire-panic", { detail: panic }));
      return;
    }
    const asked = this.#asked.get(number);
    if (asked === undefined) return;
    const { resolve, reject } = asked;
    this.#asked.delete(number);
    if (refusal !== undefined) reject(refusal);
    else if (error !== undefined) reject(isTrap ? new WebAssembly.RuntimeError(error) : new Error(error));
    else resolve(result);
  }

  /** @param {Error} error */
  #break(error) {
    this.#broken = error;
    for (const { reject } of this.#asked.values()) reject(error);
    this.#asked.clear();
  }
}

/**
 * Starts workers; none if the browser has none to give.
 * @param {number} count
 */
export function hire(count) {
  try {
    return Array.from({ length: count }, () => new Helper());
  } catch (error) {
    console.info(`The page works without workers: ${words(error)}`);
    return [];
  }
}
