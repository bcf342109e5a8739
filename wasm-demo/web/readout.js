// Times of the passes: medians over the last pictures, because a single time is mostly noise.
import { element, made } from "./elements.js";
import { median } from "./numbers.js";

const PICTURES = 30;

/** The passes of a picture. */
const PASSES = /** @type {const} */ (["geometry", "shadows", "lighting", "encode", "transfer", "show"]);

/** @param {string} name */
const place = (name) => element(`${name}-ms`);

export class Readout {
  #passes = PASSES.map((name) => ({ name, times: /** @type {number[]} */ ([]), place: place(name) }));
  #frame = place("frame");

  /**
   * Adds the times of a picture. The frame is the sum of the passes that ran for it; of the passes
   * that run in parallel, those of the share that took longest.
   * @param {Partial<Record<typeof PASSES[number], number>>} passes in milliseconds
   */
  add(passes) {
    let frame = 0;
    for (const { name, times, place } of this.#passes) {
      const time = passes[name];
      if (time !== undefined) times.push(time);
      if (times.length > PICTURES) times.shift();
      const shown = times.length === 0 ? undefined : median(times);
      tell(place, shown, time === undefined);
      if (time !== undefined) frame += shown ?? 0;
    }
    tell(this.#frame, frame, false);
  }

  /** Discards the times, because those of another number format do not apply. */
  forget() {
    for (const { times } of this.#passes) times.length = 0;
  }
}

/**
 * Shows a time, or that there is none. A pass that did not run for the last picture keeps its time
 * and is marked.
 * @param {HTMLElement} place
 * @param {number | undefined} time in milliseconds
 * @param {boolean} isKept
 */
function tell(place, time, isKept) {
  // What is always in view has a digit less: it changes with each picture.
  place.textContent = time === undefined ? "–" : `${time.toFixed(place.closest("summary") ? 1 : 2)} ms`;
  place.classList.toggle("kept", isKept);
  if (!isKept || time === undefined) return;
  place.append(made("small", {}, " kept"));
}
