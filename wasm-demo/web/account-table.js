// What was evaluated, and what was spared, by what: figures of the last pictures.
import { whole } from "./numbers.js";

/** So many pictures are averaged while a scene plays, so that the figures can be read. */
const PICTURES = 30;

/** Where the pairs of a light and a pixel went; together they are all. */
const PARTS = ["evaluated", "missedByRow", "missedByTile", "kept", "dropped"];

const element = (name) => document.getElementById(`account-${name}`);

/** A share in percent. */
const percent = (share) => (share === 0 ? "0 %" : `${Number((100 * share).toPrecision(share < 0.1 ? 2 : 3))} %`);

/** A small part of a whole, as people say it. */
function oneIn(part, all) {
  if (all === 0) return "no lights";
  if (part === 0) return "none";
  const times = all / part;
  return `1 in ${times < 10 ? Number(times.toFixed(1)) : whole(times)}`;
}

export class AccountTable {
  #accounts = [];

  /** Takes in the account of a picture of so many pixels, and shows the average. */
  add(account, pixels) {
    this.#accounts.push(account);
    if (this.#accounts.length > PICTURES) this.#accounts.shift();
    this.#show(pixels);
  }

  /** Forgets the pictures of before. */
  forget() {
    this.#accounts.length = 0;
  }

  #mean(name) {
    const sum = this.#accounts.reduce((total, account) => total + account[name], 0);
    return sum / this.#accounts.length;
  }

  #show(pixels) {
    const [pairs, lights] = [this.#mean("pairs"), this.#mean("lights")];
    for (const part of PARTS) {
      const count = this.#mean(part);
      const share = pairs === 0 ? 0 : count / pairs;
      element(part).textContent = (count / pixels).toFixed(2);
      element(`${part}-share`).textContent = percent(share);
      element(`${part}-bar`).style.flexGrow = share;
    }
    element("ratio").textContent = oneIn(this.#mean("evaluated"), pairs);
    element("pairs").textContent = `of ${whole(pairs)}: ${whole(lights)} × ${whole(pixels)}`;
    element("lights").textContent = `${whole(this.#mean("lightsDropped"))} of ${whole(lights)}`;
    element("triangles").textContent = whole(this.#mean("triangles"));
    element("shining").textContent = `${(this.#mean("evaluatedShining") / pixels).toFixed(2)} a pixel`;
    element("air").textContent = `${(this.#mean("evaluatedInAir") / pixels).toFixed(2)} a pixel`;
    element("tiles").textContent = `${whole(this.#mean("tilesRelit"))} of ${whole(this.#mean("tiles"))}`;
  }
}
