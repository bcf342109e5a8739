// What the scripts that run firmware in rp2040js share.

export const BEGIN = 0x46d2; // mov r10, r10
export const END = 0x46db; // mov r11, r11

const LOADABLE = 1; // PT_LOAD

/**
 * Yields the loadable segments of a program: their physical addresses and their bytes.
 * @param {Uint8Array} elf the program's file
 */
export function* segments(elf) {
  const file = new DataView(elf.buffer, elf.byteOffset, elf.byteLength);
  const word = (at) => file.getUint32(at, true);
  const [first, size, number] = [word(28), file.getUint16(42, true), file.getUint16(44, true)];
  for (let header = first; header < first + number * size; header += size) {
    const [kind, offset, , address, bytes] = [0, 4, 8, 12, 16].map((at) => word(header + at));
    if (kind === LOADABLE && bytes > 0) yield [address, elf.subarray(offset, offset + bytes)];
  }
}
