// The two cores of an RP2040. rp2040js has one, so the second is another of its cores on the same chip, with the
// FIFOs between the two and the part of the boot ROM that waits for its start (data sheet, 2.3.1 and 2.8.2). The
// cores take turns by their cycles. They do not wait for each other's reads of the memory.

const SIO = { CPUID: 0x00, FIFO_ST: 0x50, FIFO_WR: 0x54, FIFO_RD: 0x58 };
const [IS_VALID, IS_READY] = [1, 2]; // of FIFO_ST: something to read, room to write
const SEV = 0xbf40;

/** What starts the second core: after these words come its vector table, its stack and its first instruction. */
const GREETING = [0, 0, 1];

export class Cores {
  #cores;
  #cycles = [0, 0];
  #isStarted = false;
  /** What each core can read from its FIFO. */
  #received = [[], []];
  /** What the boot ROM of the second core has received. */
  #words = [];

  /** The core whose turn it is, 0 or 1. */
  turn = 0;

  constructor(chip) {
    const { core, sio } = chip;
    this.#cores = [core, new core.constructor(chip)];
    override(sio, "readUint32", {
      [SIO.CPUID]: () => this.turn,
      [SIO.FIFO_ST]: () => this.#status(),
      [SIO.FIFO_RD]: () => this.#received[this.turn].shift() ?? 0,
    });
    override(sio, "writeUint32", { [SIO.FIFO_ST]: () => {}, [SIO.FIFO_WR]: (word) => this.#send(word >>> 0) });
  }

  /** Chooses the core whose turn it is, and returns it. */
  next() {
    const [first, second] = this.#cycles;
    this.turn = this.#isStarted && !this.#cores[1].waiting && second < first ? 1 : 0;
    return this.#cores[this.turn];
  }

  /** Called after an instruction of the core whose turn it is. */
  executed(opcode, cycles) {
    this.#cycles[this.turn] += cycles;
    if (opcode === SEV) this.#wake(1 - this.turn);
  }

  #wake(number) {
    const core = this.#cores[number];
    core.eventRegistered = true;
    if (!core.waiting) return;
    core.waiting = false;
    this.#cycles[number] = Math.max(...this.#cycles);
  }

  #status() {
    return IS_READY | (this.#received[this.turn].length > 0 ? IS_VALID : 0);
  }

  #send(word) {
    if (this.#isStarted) this.#received[1 - this.turn].push(word);
    else this.#greet(word);
  }

  /** Does what the boot ROM of the second core does: sends back the word that it expects, and starts after the last. */
  #greet(word) {
    const words = this.#words;
    const expected = GREETING[words.length] ?? word;
    words.push(word);
    if (word !== expected) words.length = 0;
    this.#received[0].push(expected);
    if (words.length < GREETING.length + 3) return;
    const core = this.#cores[1];
    [core.VTOR, core.SP, core.PC] = [words[3], words[4], words[5] & ~1];
    this.#cycles[1] = this.#cycles[0];
    this.#isStarted = true;
  }
}

/** Lets functions answer at some offsets of a peripheral. */
function override(peripheral, name, answers) {
  const { [name]: otherwise } = peripheral;
  peripheral[name] = (offset, ...rest) => {
    const answer = answers[offset];
    return answer === undefined ? otherwise.call(peripheral, offset, ...rest) : answer(...rest);
  };
}
