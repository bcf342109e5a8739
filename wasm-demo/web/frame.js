// The next frame of the browser, in which a view draws what has changed.
import { hasFailed } from "./failure.js";

export class Frame {
  #draw;
  #number = 0;

  /** @param {() => void} draw */
  constructor(draw) {
    this.#draw = draw;
  }

  /** Draws with the next frame of the browser, once for any number of calls. */
  request() {
    if (this.#number === 0 && !hasFailed()) this.#number = requestAnimationFrame(() => this.draw());
  }

  /** Draws now, in place of what was requested. */
  draw() {
    this.cancel();
    this.#draw();
  }

  cancel() {
    cancelAnimationFrame(this.#number);
    this.#number = 0;
  }
}
