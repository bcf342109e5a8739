// Table of evaluated and skipped pairs, averaged over the last pictures.
import { element as find } from "./elements.js";
import { percent, whole } from "./numbers.js";

/** @typedef {import("./pkg/wasm_demo.js").AccountState} Account */

/** Number of pictures that are averaged while a scene plays, so that the figures are readable. */
const PICTURES = 30;

/** Categories of the (light, pixel) pairs; together they are all pairs. */
const PARTS = /** @type {const} */ (["evaluated", "missedByRow", "missedByTile", "kept", "dropped"]);

/** @param {string} name */
const element = (name) => find(`account-${name}`);

/**
 * Formats a small share in words.
 * @param {number} part
 * @param {number} all
 */
function oneIn(part, all) {
  if (all === 0) return "no lights";
  if (part === 0) return "none";
  const times = all / part;
  return `1 in ${times < 10 ? Number(times.toFixed(1)) : whole(times)}`;
}

export class AccountTable {
  #accounts = /** @type {Account[]} */ ([]);

  /**
   * Adds the account of a picture, and shows the average.
   * @param {Account} account
   * @param {number} pixels the size of the picture
   */
  add(account, pixels) {
    this.#accounts.push(account);
    if (this.#accounts.length > PICTURES) this.#accounts.shift();
    this.#show(pixels);
  }

  /** Discards the earlier pictures. */
  forget() {
    this.#accounts.length = 0;
  }

  /** @param {keyof Account} name */
  #mean(name) {
    const sum = this.#accounts.reduce((total, account) => total + account[name], 0);
    return sum / this.#accounts.length;
  }

  /** @param {number} pixels */
  #show(pixels) {
    const [pairs, lights] = [this.#mean("pairs"), this.#mean("lights")];
    for (const part of PARTS) {
      const count = this.#mean(part);
      const share = pairs === 0 ? 0 : count / pairs;
      element(part).textContent = (count / pixels).toFixed(2);
      element(`${part}-share`).textContent = percent(share, "0 %");
      element(`${part}-bar`).style.flexGrow = String(share);
    }
    element("ratio").textContent = oneIn(this.#mean("evaluated"), pairs);
    element("pairs").textContent = `of ${whole(pairs)}, a light at a pixel`;
    element("lights").textContent = `${whole(this.#mean("lightsDropped"))} of ${whole(lights)}`;
    element("triangles").textContent = whole(this.#mean("triangles"));
    for (const [name, count] of /** @type {const} */ ([["shining", "evaluatedShining"], ["air", "evaluatedInAir"]])) {
      const mean = this.#mean(count);
      element(name).textContent = `${(mean / pixels).toFixed(2)} a pixel`;
      // A scene without highlights or haze has no count of them.
      element(name).parentElement?.toggleAttribute("hidden", mean === 0);
    }
    element("tiles").textContent = `${whole(this.#mean("tilesRelit"))} of ${whole(this.#mean("tiles"))}`;
  }
}
