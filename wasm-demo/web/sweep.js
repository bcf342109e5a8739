// The switch that makes the lights move.

export class Sweep {
  #demo;
  #switch = document.getElementById("sweep");
  #seconds = 0;
  #last;

  /** Called when the lights start or stop. */
  onchange = () => {};

  constructor(demo) {
    this.#demo = demo;
    this.#switch.addEventListener("input", () => {
      this.#last = undefined;
      this.onchange();
    });
  }

  /**
   * Moves the lights up to this moment. Stopped lights keep their position and continue from there.
   * @param {number} now in milliseconds
   * @returns {boolean} whether they are moving
   */
  step(now) {
    if (!this.#switch.checked) return false;
    this.#seconds += (now - (this.#last ?? now)) / 1000;
    this.#last = now;
    this.#demo.sweep(this.#seconds);
    return true;
  }
}
