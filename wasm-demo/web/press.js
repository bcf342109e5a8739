// Distinguishes a drag from a click, whose pointer also moves by a pixel or two.

/** Distance from which on a press is a drag, in pixels of the page. */
const SLIP = 3;

/** A press of the pointer on a handle. */
export class Press {
  /** @type {PointerEvent | undefined} */
  #down;

  /** @param {PointerEvent} down where it began */
  constructor(down) {
    this.#down = down;
  }

  /**
   * Whether the press is a drag. Once it is, it stays one wherever the pointer goes.
   * @param {PointerEvent} move
   */
  isDrag(move) {
    if (this.#down && Math.hypot(move.clientX - this.#down.clientX, move.clientY - this.#down.clientY) < SLIP) return false;
    this.#down = undefined;
    return true;
  }
}
