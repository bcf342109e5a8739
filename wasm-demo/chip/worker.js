// Runs the firmware of the RP2040's board, and compares each pixel that its display receives with
// the one that the same code draws in this browser. Takes orders from the page, and tells it what
// the board has shown:
//
//   orders: { run: boolean }, { speed: number }, { step: "row" | "picture" }
//   news:   { stages }, { failure }, { nanos, wallMs, rows }, { picture }

import { Simulator } from "rp2040js";
import { Board } from "../../examples/boards/emulator/board.mjs";
import init, { Expected, stages } from "./chip/luminaire_chip.js";

/** Milliseconds between two looks at the page's orders. */
const SLICE = 12;
/** Instructions between two looks at the display: a row takes some 40,000. */
const BATCH = 2_000;

class Chip {
  #board;
  #stages;
  /** How many pictures have begun. */
  #count = 0;
  #picture;
  #expected;
  /** Rows of the picture that have been compared. */
  #compared = 0;
  #differing = 0;
  #rows = [];
  /** Instructions and cycles of each stage of the picture. */
  #sums = [];
  /** Regions of the picture that each core has ended. */
  #marked = [0, 0];
  #begun = 0;
  #pictures = [];

  constructor(elf, stages) {
    this.#board = new Board(Simulator, elf);
    this.#stages = stages.length;
    this.#board.display.onpicture = (picture) => this.#begin(picture);
    this.#board.onregion = (instructions, cycles, _misses, core) => {
      const sum = this.#sums[this.#marked[core] % this.#stages];
      this.#marked[core] += 1;
      sum[0] += instructions;
      sum[1] += cycles;
    };
    this.#board.online = (line) => this.#end(line);
  }

  get nanos() {
    return this.#board.nanos;
  }

  /** Rows and pictures that have ended. */
  get done() {
    return { row: this.#count * 1000 + this.#compared, picture: this.#pictures.length };
  }

  run() {
    this.#board.run(BATCH);
    this.#compare();
  }

  /** Takes what is new since the last call. */
  take() {
    const [rows, pictures] = [this.#rows, this.#pictures];
    [this.#rows, this.#pictures] = [[], []];
    return { rows, pictures };
  }

  #begin(picture) {
    this.#picture = picture;
    this.#expected = new Expected(this.#count);
    this.#expected.drawn = this.#expected.pixels;
    this.#count += 1;
    [this.#compared, this.#differing, this.#marked, this.#begun] = [0, 0, [0, 0], this.nanos];
    this.#sums = Array.from({ length: this.#stages }, () => [0, 0]);
  }

  /** Compares the rows that have been received. */
  #compare() {
    if (this.#picture === undefined) return;
    const { columns, rows, pixels } = this.#picture;
    const width = columns[1] - columns[0] + 1;
    for (; pixels.length >= (this.#compared + 1) * width; this.#compared += 1) {
      const start = this.#compared * width;
      const received = Uint16Array.from(pixels.slice(start, start + width));
      const differs = (pixel, at) => pixel !== this.#expected.drawn[start + at];
      this.#differing += received.filter(differs).length;
      this.#rows.push({ column: columns[0], row: rows[0] + this.#compared, pixels: received });
    }
  }

  /** The firmware has printed the line of a picture: the picture is complete. */
  #end(line) {
    this.#compare();
    const { columns, rows, pixels } = this.#picture;
    const expected = this.#expected;
    const isPlaced = String([columns, rows].flat()) === String(Array.from(expected.window));
    this.#pictures.push({
      line,
      name: expected.name,
      count: pixels.length,
      // A picture at another place, or of another size, has no pixel that is right.
      differing: isPlaced && pixels.length === expected.drawn.length ? this.#differing : expected.drawn.length,
      checksum: expected.checksum.toString(16).padStart(8, "0"),
      stages: this.#sums,
      nanos: this.nanos - this.#begun,
    });
    expected.free();
  }
}

let chip;
let isRunning = false;
/** The chip's time by the time that passes here; without a limit, as fast as possible. */
let speed = Infinity;
/** Milliseconds that the chip has been running. */
let wallMs = 0;
/** Whether a slice is under way or waits for its turn. */
let isBusy = false;

const turns = new MessageChannel();
turns.port1.onmessage = () => slice();

function tell() {
  const { rows, pictures } = chip.take();
  postMessage({ nanos: chip.nanos, wallMs, rows });
  for (const picture of pictures) postMessage({ picture });
}

/** Runs the chip for a short time, and then looks at the orders. */
function slice() {
  isBusy = false;
  if (!isRunning) return;
  const start = performance.now();
  const most = chip.nanos + speed * SLICE * 1e6;
  while (performance.now() - start < SLICE && chip.nanos < most) chip.run();
  const spent = performance.now() - start;
  isBusy = true;
  const rest = speed === Infinity ? 0 : SLICE - spent;
  if (rest > 0) setTimeout(slice, rest);
  else turns.port2.postMessage(0);
  wallMs += Math.max(spent, rest > 0 ? SLICE : 0);
  tell();
}

/** Runs the chip until a row or a picture has ended. */
function step(what) {
  const start = performance.now();
  const before = chip.done[what];
  while (chip.done[what] === before) chip.run();
  wallMs += performance.now() - start;
  tell();
}

onmessage = ({ data }) => {
  if (data.speed !== undefined) speed = data.speed;
  if (data.run !== undefined) isRunning = data.run;
  if (data.step !== undefined) step(data.step);
  if (isRunning && !isBusy) slice();
};

/** Fetches the firmware. */
async function firmware() {
  const answer = await fetch("rp2040.elf");
  if (!answer.ok) throw new Error(`rp2040.elf: the server answers ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

try {
  const [elf] = await Promise.all([firmware(), init()]);
  const names = stages();
  chip = new Chip(elf, names);
  postMessage({ stages: names });
} catch (error) {
  postMessage({ failure: String(error?.message ?? error) });
}
