// The RP2040's board in rp2040js: runs its firmware from the second stage of the boot on, on two cores, with an
// ST7789 at SPI0, and counts the instructions and cycles between the markers, and there the misses of the
// flash's cache by a model. The cycles are those without misses. Runs in Node.js and in a browser.

import { Cache } from "./cache.mjs";
import { Cores } from "./cores.mjs";
import { Display } from "./display.mjs";
import { BEGIN, END, segments } from "./elf.mjs";

const FLASH = 0x10000000;
const RAM = 0x20000000;
const STAGE2_BYTES = 256;
const STAGE2_PLACE = 0x20041f00; // where the boot ROM runs the second stage
const TIMER = 0x40054;
const TIMERAWL = 0x28;
const IS_DATA = 16; // the pin that tells commands from data
/**
 * Nanoseconds that pass with each look at the timer. The firmware looks at it only to wait while the
 * display starts: 300 ms, in 24 million instructions without this.
 */
const LOOK = 10_000;

/** Each byte of the RAM before it is written: as an instruction, one that is undefined. */
const UNDEFINED = 0xde;

const NOTHING = () => {};

export class Board {
  #cache = new Cache();
  #chip;
  #clock;
  #cores;
  #flash;
  #ram;
  /** The region that each core is in. */
  #regions = [];
  #text = "";

  /** The display. */
  display = new Display();
  /** Called with each line that the UART prints. */
  online = (_line) => {};
  /**
   * Called with the instructions, the cycles and the misses of the cache of each marked region at its end, and
   * with the number of the core that executed it.
   */
  onregion = (_instructions, _cycles, _misses, _core) => {};

  /**
   * @param {Function} Simulator the class of rp2040js
   * @param {Uint8Array} elf the firmware's file
   * @param {boolean} isCached whether to count the misses of the cache, which takes time; else they are 0
   */
  constructor(Simulator, elf, isCached = false) {
    const { rp2040: chip, clock } = new Simulator();
    [this.#chip, this.#clock, this.#cores] = [chip, clock, new Cores(chip)];
    const fail = (part, text) => {
      throw new Error(`${part}: ${text}`);
    };
    chip.logger = { debug: NOTHING, info: NOTHING, warn: NOTHING, error: fail };
    chip.sram.fill(UNDEFINED);
    chip.onBreak = () => fail("core", "executes an undefined instruction, such as RAM that was never written");
    for (const [address, bytes] of segments(elf)) chip.flash.set(bytes, address - FLASH);
    [this.#flash, this.#ram] = [chip.flash, chip.sram].map(
      ({ buffer, byteOffset, length }) => new Uint16Array(buffer, byteOffset, length / 2),
    );
    this.#connect();
    if (isCached) this.#watch();
    this.#boot();
  }

  /** Nanoseconds since the start, in the time of the chip. */
  get nanos() {
    return this.#clock.nanos;
  }

  /** Cycles of the processor's clock a second. */
  get frequency() {
    return this.#chip.clkSys;
  }

  /** Executes instructions. */
  run(count) {
    const [chip, clock, flash, ram] = [this.#chip, this.#clock, this.#flash, this.#ram];
    const [cores, regions] = [this.#cores, this.#regions];
    const { misses } = this.#cache;
    for (let i = 0; i < count; i++) {
      const core = cores.next();
      const { turn } = cores;
      const { PC: place } = core;
      const opcode = place < RAM ? flash[(place - FLASH) >>> 1] : ram[(place - RAM) >>> 1];
      const cycles = core.executeInstruction();
      cores.executed(opcode, cycles);
      if (turn === 0) clock.tick((cycles * 1e9) / chip.clkSys);
      if (opcode === BEGIN) {
        regions[turn] = [0, 0, ...misses.map((counts) => counts[turn])];
      } else if (opcode === END) {
        const [instructions, cycles, ...before] = regions[turn];
        const more = misses.map((counts, model) => counts[turn] - before[model]);
        this.onregion(instructions, cycles, Math.max(...more), turn);
        regions[turn] = undefined;
      } else if (regions[turn]) {
        regions[turn][0] += 1;
        regions[turn][1] += cycles;
      }
    }
  }

  #connect() {
    const [chip, clock, display] = [this.#chip, this.#clock, this.display];
    const spi = chip.spi[0];
    const sent = clock.createAlarm(() => spi.completeTransmit(0));
    spi.onTransmit = (word) => {
      const isData = chip.gpio[IS_DATA].value === 1;
      for (let shift = spi.dataBits - 8; shift >= 0; shift -= 8) display.receive((word >> shift) & 0xff, isData);
      sent.schedule((spi.dataBits * 1e9) / spi.clockFrequency);
    };
    chip.uart[0].onByte = (byte) => {
      this.#text += String.fromCharCode(byte);
      if (!this.#text.endsWith("\r\n")) return;
      this.online(this.#text.slice(0, -2));
      this.#text = "";
    };
    const timer = chip.peripherals[TIMER];
    const read = timer.readUint32;
    timer.readUint32 = (offset) => {
      if (offset === TIMERAWL) clock.tick(LOOK);
      return read.call(timer, offset);
    };
  }

  /** Lets the cache see each read of the flash. */
  #watch() {
    const [chip, cache] = [this.#chip, this.#cache];
    for (const name of ["readUint8", "readUint16", "readUint32"]) {
      const read = chip[name];
      chip[name] = (address) => {
        if (address >>> 24 === FLASH >>> 24) cache.read(address - FLASH, this.#cores.turn);
        return read.call(chip, address);
      };
    }
  }

  /** Does what the boot ROM does: checks the second stage, copies it to RAM and starts it. */
  #boot() {
    const { core, flash } = this.#chip;
    const stage2 = flash.subarray(0, STAGE2_BYTES);
    const sum = new DataView(stage2.buffer, stage2.byteOffset).getUint32(STAGE2_BYTES - 4, true);
    if (checksum(stage2.subarray(0, -4)) !== sum) {
      throw new Error("the boot ROM would refuse the second stage of the boot: its checksum is wrong");
    }
    stage2.forEach((byte, at) => this.#chip.writeUint8(STAGE2_PLACE + at, byte));
    core.SP = STAGE2_PLACE;
    core.LR = 0; // the second stage starts the program, instead of returning
    core.PC = STAGE2_PLACE;
  }
}

/** The boot ROM's checksum: CRC-32, most significant bit first. */
function checksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) sum = (sum << 1) ^ (sum < 0 ? 0x04c11db7 : 0);
  }
  return sum >>> 0;
}
