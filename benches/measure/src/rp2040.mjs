// Runs firmware for the Cortex-M0 on the core of an RP2040, emulated by rp2040js, and counts the
// instructions and cycles of every region between the markers. The core is a Cortex-M0+ without
// wait states: the program is in the memory of the boot ROM, at address 0.
//
//   node rp2040.mjs FOLDER-OF-RP2040JS FIRMWARE COUNTS
//
// Prints what the firmware prints. The file COUNTS gets one line for each region, instructions and
// cycles. Ends with the firmware's exit code.

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { BEGIN, END, segments } from "../../../examples/boards/emulator/elf.mjs";

const [library, firmware, counts] = process.argv.slice(2);
const entry = path.join(library, "dist", "esm", "index.js");
const { RP2040 } = await import(pathToFileURL(entry).href);

const ROM_BYTES = 256 * 1024;

const chip = new RP2040();
const core = chip.core;

/** Copies the segments of an ELF file into the ROM and returns it as 16-bit words. */
function load(file) {
  chip.bootrom = new Uint32Array(ROM_BYTES / 4);
  for (const [address, bytes] of segments(fs.readFileSync(file))) Buffer.from(chip.bootrom.buffer).set(bytes, address);
  [core.SP, core.PC, core.VTOR] = [chip.bootrom[0], chip.bootrom[1] & ~1, 0];
  return new Uint16Array(chip.bootrom.buffer);
}

const word = (address) => chip.readUint32(address) >>> 0;
const text = (address, bytes) =>
  Buffer.from(Array.from({ length: bytes }, (_, i) => chip.readUint8(address + i)));

let exit;

/** Semihosting of the operations that the firmware calls. */
chip.onBreak = (kind) => {
  const [operation, at] = [core.registers[0] >>> 0, core.registers[1] >>> 0];
  let answer = 0;
  if (kind !== 0xab) exit = 1;
  else if (operation === 0x01) answer = 1 + (word(at + 4) >= 8); // SYS_OPEN of :tt, as 1 or 2
  else if (operation === 0x05) process.stdout.write(text(word(at + 4), word(at + 8))); // SYS_WRITE
  else if (operation === 0x18) exit = at === 0x20026 ? 0 : 1; // SYS_EXIT: the application has ended
  else if (operation === 0x20) exit = word(at + 4); // SYS_EXIT_EXTENDED
  else answer = -1;
  core.registers[0] = answer;
};

const rom = load(firmware);
const regions = [];
let region;
while (exit === undefined) {
  const opcode = rom[core.PC >>> 1];
  const cycles = core.executeInstruction();
  if (opcode === BEGIN) {
    region = [0, 0];
  } else if (opcode === END) {
    regions.push(region);
    region = undefined;
  } else if (region) {
    region[0] += 1;
    region[1] += cycles;
  }
}
fs.writeFileSync(counts, regions.map((counted) => `${counted.join(" ")}\n`).join(""));
process.exitCode = exit;
