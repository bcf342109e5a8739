// Runs the firmware of the RP2040's board in rp2040js.
//
//   node rp2040.mjs FOLDER-OF-RP2040JS FIRMWARE PICTURES RESULT
//
// Runs until UART0 has printed a line for each of the first PICTURES pictures. The file RESULT gets,
// as JSON, the lines, the window and the pixels of each picture that the display received, and the
// instructions, cycles and misses of the cache of each region between the markers.

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { Board } from "../../../../examples/boards/emulator/board.mjs";

const [library, firmware, count, result] = process.argv.slice(2);
const entry = path.join(library, "dist", "esm", "index.js");
const { Simulator } = await import(pathToFileURL(entry).href);

const PATIENCE = 1e10; // nanoseconds of the chip for each picture
const BATCH = 100_000; // instructions between two looks at the lines

const [lines, pictures, regions] = [[], [], []];
const board = new Board(Simulator, fs.readFileSync(firmware), true);
board.display.onpicture = (picture) => pictures.push(picture);
board.online = (line) => lines.push(line);
board.onregion = (instructions, cycles, misses) => regions.push([instructions, cycles, misses]);
while (lines.length < count) {
  if (board.nanos > count * PATIENCE) throw new Error(`the firmware has printed only: ${lines.join("; ")}`);
  board.run(BATCH);
}
const first = (list) => list.slice(0, count);
fs.writeFileSync(result, JSON.stringify({ lines: first(lines), pictures: first(pictures), regions }));
