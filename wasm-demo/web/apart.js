// How far pictures are apart: one sentence in every view.
import { percent, whole } from "./numbers.js";

/** @typedef {{ pixels: number, differing: number, beyond?: number, most: number }} Difference of displayed codes */

/**
 * States how far pictures are apart, in the words of every view.
 * @param {Difference} difference
 * @param {string} reference what the picture is compared with
 */
export function apart({ pixels, differing, beyond = 0, most }, reference) {
  if (differing === 0) return `all pixels are those of ${reference}`;
  const share = `${percent(differing / pixels, "none")} of the pixels differ from ${reference}`;
  // Few may differ by more than rounding: beside the edges of shadows.
  if (most < 3 || beyond === 0 || beyond === differing) return `${share}, by at most ${most} of 255`;
  return `${share}, by 1 of 255, and ${whole(beyond)} of them by up to ${most}`;
}
