// Runs the firmware of an RP2040 board in rp2040js, from the second stage of the boot on, with an
// ST7789 display at SPI0, and counts the instructions and cycles between the markers. The memory has
// no wait states.
//
//   node rp2040.mjs FOLDER-OF-RP2040JS FIRMWARE PICTURES RESULT
//
// Runs until UART0 has printed a line for each of the first PICTURES pictures. The file RESULT gets,
// as JSON, the lines, the window and the pixels of each picture that the display received, and the
// counts of each region.

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { BEGIN, END, segments } from "../boards/elf.mjs";

const [library, firmware, count, result] = process.argv.slice(2);
const entry = path.join(library, "dist", "esm", "index.js");
const { Simulator } = await import(pathToFileURL(entry).href);

const FLASH = 0x10000000;
const STAGE2_BYTES = 256;
const STAGE2_PLACE = 0x20041f00; // where the boot ROM runs the second stage
const IS_DATA = 16; // the pin that tells commands from data
const PATIENCE = 1e10; // nanoseconds of the chip for each picture
const BATCH = 100_000; // instructions between two looks at the lines

const { rp2040: chip, clock } = new Simulator();
const core = chip.core;
const flash = Buffer.from(chip.flash.buffer, chip.flash.byteOffset, chip.flash.byteLength);

/** The boot ROM's checksum: CRC-32, most significant bit first. */
function checksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) sum = (sum << 1) ^ (sum < 0 ? 0x04c11db7 : 0);
  }
  return sum >>> 0;
}

/** Does what the boot ROM does: checks the second stage, copies it to RAM and starts it. */
function boot() {
  const stage2 = flash.subarray(0, STAGE2_BYTES);
  const end = STAGE2_BYTES - 4;
  if (checksum(stage2.subarray(0, end)) !== stage2.readUInt32LE(end)) {
    throw new Error("the boot ROM would refuse the second stage of the boot: its checksum is wrong");
  }
  stage2.forEach((byte, at) => chip.writeUint8(STAGE2_PLACE + at, byte));
  core.SP = STAGE2_PLACE;
  core.LR = 0; // the second stage starts the program, instead of returning
  core.PC = STAGE2_PLACE;
}

/** An ST7789: keeps the pixels that it receives, by the window that was open. */
class Display {
  pictures = [];
  #columns;
  #rows;
  #command;
  #bytes = [];

  receive(byte, isData) {
    if (!isData) {
      [this.#command, this.#bytes] = [byte, []];
      if (byte === 0x2c) this.pictures.push({ columns: this.#columns, rows: this.#rows, pixels: [] }); // RAMWR
      return;
    }
    this.#bytes.push(byte);
    if (this.#command === 0x2a && this.#bytes.length === 4) this.#columns = this.#words(); // CASET
    if (this.#command === 0x2b && this.#bytes.length === 4) this.#rows = this.#words(); // RASET
    if (this.#command === 0x2c && this.#bytes.length === 2) this.pictures.at(-1).pixels.push(...this.#words());
  }

  /** Takes the bytes as words, upper byte first. */
  #words() {
    const bytes = Buffer.from(this.#bytes);
    this.#bytes = [];
    return Array.from({ length: bytes.length / 2 }, (_, i) => bytes.readUInt16BE(2 * i));
  }
}

const display = new Display();
const spi = chip.spi[0];
const sent = clock.createAlarm(() => spi.completeTransmit(0));
spi.onTransmit = (word) => {
  const isData = chip.gpio[IS_DATA].value === 1;
  for (let shift = spi.dataBits - 8; shift >= 0; shift -= 8) display.receive((word >> shift) & 0xff, isData);
  sent.schedule((spi.dataBits * 1e9) / spi.clockFrequency);
};

let text = "";
chip.uart[0].onByte = (byte) => (text += String.fromCharCode(byte));

const regions = [];
let region;

/** Executes an instruction, and counts it if it is in a region. */
function step() {
  const opcode = core.PC >= FLASH && core.PC < FLASH + flash.length ? flash.readUInt16LE(core.PC - FLASH) : 0;
  const cycles = core.executeInstruction();
  clock.tick((cycles * 1e9) / chip.clkSys);
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

for (const [address, bytes] of segments(firmware)) flash.set(bytes, address - FLASH);
boot();
const lines = () => text.split("\r\n").slice(0, -1);
while (lines().length < count) {
  if (clock.nanos > count * PATIENCE) throw new Error(`the firmware has printed only: ${lines().join("; ")}`);
  for (let i = 0; i < BATCH; i++) step();
}
const pictures = display.pictures.slice(0, count);
fs.writeFileSync(result, JSON.stringify({ lines: lines().slice(0, count), pictures, regions }));
