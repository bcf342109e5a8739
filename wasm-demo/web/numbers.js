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
 * Formats an angle in degrees with three significant digits.
 * @param {number} value
 */
export const roughly = (value) => `${Number(value.toPrecision(3))}°`;

/**
 * Formats a rounded number with thousands separators.
 * @param {number} value
 */
export const whole = (value) => Math.round(value).toLocaleString("en");

/**
 * Rounds down to two decimals, for the end of a slider that the kernel must accept.
 * @param {number} value
 */
export const floor = (value) => Math.floor(value * 100) / 100;

/**
 * Rounds up to three significant digits.
 * @param {number} value
 */
export function ceiling(value) {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 2);
  return Number((Math.ceil(value / unit) * unit).toPrecision(3));
}

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
