// A model of the RP2040's cache of its flash: 16 kB in lines of 8 bytes, two in a set (data sheet, 2.6.3).
// The data sheet does not say which of the two lines a miss replaces, so two models count: one replaces the line
// that was not read for longer, the other one of them at random.

const LINE_BITS = 3;
const SETS = 1024;

export class Cache {
  #tags = [0, 1].map(() => new Int32Array(2 * SETS).fill(-1));
  #recent = new Uint8Array(SETS);
  #random = 1;

  /** The misses of the two models, each by the core that reads. */
  misses = [0, 1].map(() => [0, 0]);

  /** A core reads at an offset in the flash. */
  read(offset, core) {
    const line = offset >>> LINE_BITS;
    const set = line & (SETS - 1);
    const [orderly, random] = this.#tags;
    let way = orderly[2 * set] === line ? 0 : 1;
    if (orderly[2 * set + way] !== line) {
      this.misses[0][core] += 1;
      way = 1 - this.#recent[set];
      orderly[2 * set + way] = line;
    }
    this.#recent[set] = way;
    if (random[2 * set] === line || random[2 * set + 1] === line) return;
    this.misses[1][core] += 1;
    random[2 * set + this.#bit()] = line;
  }

  /** A random bit: Marsaglia's xorshift. */
  #bit() {
    this.#random ^= this.#random << 13;
    this.#random ^= this.#random >>> 17;
    this.#random ^= this.#random << 5;
    return (this.#random >>> 16) & 1;
  }
}
