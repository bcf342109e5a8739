// An ST7789 as its bus sees it: decodes the commands that open windows and the pixels that fill them.

const SET_COLUMNS = 0x2a; // CASET
const SET_ROWS = 0x2b; // RASET
const WRITE = 0x2c; // RAMWR

/**
 * What was written into a window.
 * @typedef {object} Picture
 * @property {[number, number]} columns the first and the last column
 * @property {[number, number]} rows the first and the last row
 * @property {number[]} pixels RGB565, row by row, as many as have been received
 */

export class Display {
  #columns;
  #rows;
  #command;
  #bytes = [];
  #picture;

  /** Called with each picture before its first pixel. */
  onpicture = (_picture) => {};

  /** Receives a byte with the level of the pin D/C: low for commands. */
  receive(byte, isData) {
    if (!isData) {
      [this.#command, this.#bytes] = [byte, []];
      if (byte === WRITE) this.onpicture((this.#picture = { columns: this.#columns, rows: this.#rows, pixels: [] }));
      return;
    }
    const bytes = this.#bytes;
    bytes.push(byte);
    if (this.#command === SET_COLUMNS && bytes.length === 4) this.#columns = this.#words();
    else if (this.#command === SET_ROWS && bytes.length === 4) this.#rows = this.#words();
    else if (this.#command === WRITE && bytes.length === 2) this.#picture.pixels.push(...this.#words());
  }

  /** Takes the bytes as words, upper byte first. */
  #words() {
    const bytes = this.#bytes;
    this.#bytes = [];
    return Array.from({ length: bytes.length / 2 }, (_, i) => (bytes[2 * i] << 8) | bytes[2 * i + 1]);
  }
}
