// What the scripts that run firmware in rp2040js share.

import fs from "node:fs";

export const BEGIN = 0x46d2; // mov r10, r10
export const END = 0x46db; // mov r11, r11

const LOADABLE = 1; // PT_LOAD

/** Yields the loadable segments of an ELF file: their physical addresses and their bytes. */
export function* segments(file) {
  const elf = fs.readFileSync(file);
  const [first, size, number] = [elf.readUInt32LE(28), elf.readUInt16LE(42), elf.readUInt16LE(44)];
  for (let header = first; header < first + number * size; header += size) {
    const [kind, offset, , address, bytes] = [0, 4, 8, 12, 16].map((at) => elf.readUInt32LE(header + at));
    if (kind === LOADABLE && bytes > 0) yield [address, elf.subarray(offset, offset + bytes)];
  }
}
