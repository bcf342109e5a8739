// Numbers as people read them.

/**
 * A value with as many decimals as matter: two, or more where it is small.
 * @param {number} value
 */
export function tidy(value) {
  const size = Math.abs(value);
  return Number(size > 0 && size < 1 ? value.toPrecision(3) : value.toFixed(2));
}

/**
 * An angle in degrees, with its sign.
 * @param {number} value
 */
export const degrees = (value) => `${tidy(value)}°`.replace("-", "−");

/**
 * Formats a rounded number with thousands separators.
 * @param {number} value
 */
export const whole = (value) => Math.round(value).toLocaleString("en");

/**
 * Formats a share in percent.
 * @param {number} share
 * @param {string} none for a share of 0
 */
export const percent = (share, none) => (share === 0 ? none : `${Number((100 * share).toPrecision(share < 0.1 ? 2 : 3))} %`);

/**
 * Formats a number of things.
 * @param {number} count
 * @param {string} thing
 */
export const counted = (count, thing) => `${count.toLocaleString("en")} ${thing}${count === 1 ? "" : "s"}`;

/**
 * Rounds an f32 to 7 significant digits, which restores the decimal fraction that was set.
 * @param {number} value
 */
export const exact = (value) => Number(value.toPrecision(7));

/**
 * The middle one of some numbers; of an even count the mean of the middle two.
 * @param {number[]} values
 */
export function median(values) {
  const sorted = Float64Array.from(values).sort();
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * Colours as CSS has them, from three bytes each.
 * @param {Uint8Array | Uint8ClampedArray} bytes
 */
export function colours(bytes) {
  /** @type {(_: unknown, i: number) => string} */
  const colour = (_, i) => `rgb(${bytes.slice(3 * i, 3 * i + 3).join(" ")})`;
  return Array.from({ length: bytes.length / 3 }, colour);
}
