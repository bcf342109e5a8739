// The counted prices of the effects that have a switch.
import { whole } from "./numbers.js";

/** The processor of the prices, as the list and as people call it. */
const CHIP = { name: "cortex-m0", words: "Cortex-M0" };

/** The program of the list that measures each switch. */
const PROGRAMS = {
  specular: "difference-form",
  gobo: "spot-soft-lambert-gobo",
  shadow: "spot-soft-lambert-shadow",
  haze: "haze",
  dither: "dither",
  "keep-hue": "keep-hue",
};

/**
 * The part of the list that is read.
 * @typedef {{ instructions: number, bytes: number }} Price of a program
 * @typedef {object} List
 * @property {Record<string, { prices: Record<string, Price> }>} boards
 * @property {{ program: string, over?: string }[]} effects `over` is the program that it stands on
 */

/** What the numbers are, for people. */
export const MEANING = `Beside each switch: instructions for each light and pixel, and bytes of code, that it adds in 16 bits on a ${CHIP.words}.`;

/**
 * Loads the prices: a map from the name of a switch to what it adds to the program that it stands on,
 * in words. Empty if the list does not load; the page works without it.
 */
export async function loadPrices() {
  /** @type {List | undefined} */
  let list;
  try {
    const answer = await fetch(new URL("effects.json", import.meta.url));
    if (!answer.ok) throw new Error(answer.statusText);
    list = await answer.json();
  } catch (error) {
    console.info(`The prices of the effects are not shown: ${error}`);
  }
  const prices = /** @type {Record<string, Price | undefined>} */ (list?.boards[CHIP.name]?.prices ?? {});
  /** @type {[string, string][]} */
  const told = Object.entries(PROGRAMS).flatMap(([effect, program]) => {
    const over = list?.effects.find((row) => row.program === program)?.over;
    const none = { instructions: 0, bytes: 0 };
    const [price, base] = [prices[program], over === undefined ? none : prices[over]];
    if (!price || !base) return [];
    /** @type {(what: keyof Price) => string} */
    const added = (what) => whole(price[what] - base[what]);
    return [[effect, `+${added("instructions")}, ${added("bytes")} B`]];
  });
  return new Map(told);
}
