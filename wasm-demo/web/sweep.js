// The edge between both halves of a divided picture moves by itself.

/** What the edge does for a new visitor: a place on the picture in percent, and the seconds until it is there. */
export const OVER = /** @type {const} */ ([[100, 0], [6, 2.6], [6, 0.8], [100, 2.6]]);

/** What it does when the visitor divides the picture. */
export const OPEN = /** @type {const} */ ([[100, 0], [50, 0.9]]);

export class Sweep {
  #move;
  #frame = 0;

  /** @param {(percent: number) => void} move puts the edge at a place */
  constructor(move) {
    this.#move = move;
  }

  /** Whether the edge moves. */
  get isMoving() {
    return this.#frame !== 0;
  }

  /**
   * Moves the edge from place to place, in place of what it did.
   * @param {readonly (readonly [number, number])[]} path
   * @param {() => void} [onend] called once it has arrived, and not if it is stopped
   */
  start(path, onend) {
    this.stop();
    let [[from]] = path;
    let leg = 1;
    /** @type {number | undefined} */
    let start;
    this.#move(from);
    /** @param {number} now */
    const step = (now) => {
      start ??= now;
      const [to, seconds] = path[leg];
      const share = Math.min((now - start) / (1000 * seconds), 1);
      // It begins and ends slowly.
      this.#move(from + (to - from) * share * share * (3 - 2 * share));
      if (share === 1) [from, start, leg] = [to, now, leg + 1];
      this.#frame = leg < path.length ? requestAnimationFrame(step) : 0;
      if (this.#frame === 0) onend?.();
    };
    this.#frame = requestAnimationFrame(step);
  }

  /** Leaves the edge where it is. */
  stop() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }
}
