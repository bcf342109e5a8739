// How long the passes take: the median of the last pictures, since one picture's time is mostly chance.
import { median } from "./numbers.js";

const PICTURES = 30;

/** The passes of a picture, and all that were done for it together. */
const PASSES = ["geometry", "shadows", "lighting", "encode", "show", "frame"];

export class Readout {
  #demo;
  #passes;

  /** @param {string} [prefix] what the ids of the places begin with */
  constructor(demo, prefix = "") {
    this.#demo = demo;
    const place = (name) => document.getElementById(`${prefix}${name}-ms`);
    this.#passes = PASSES.map((name) => ({ name, times: [], place: place(name) }));
  }

  /** Takes in the times of the picture just drawn. */
  add() {
    for (const { name, times, place } of this.#passes) {
      const time = this.#demo[`${name}Ms`];
      // A picture that is only lit anew has no geometry: a pass that was not done keeps its last reading.
      if (time === undefined) continue;
      times.push(time);
      if (times.length > PICTURES) times.shift();
      place.textContent = `${median(times).toFixed(2)} ms`;
    }
  }

  /** Forgets the times, as those of another number format say nothing. */
  forget() {
    for (const { times } of this.#passes) times.length = 0;
  }
}
