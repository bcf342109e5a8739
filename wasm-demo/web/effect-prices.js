// The counted prices of the effects that have a switch.
/** The processor of the prices, as the list and as people call it. */
const CHIP = { name: "cortex-m0", words: "Cortex-M0" };

/**
 * The program of the list that measures each switch, and the program that it stands on.
 * @type {Record<string, [string, string?]>}
 */
const PROGRAMS = {
  specular: ["difference-form.fx16", "matte.fx16"],
  gobo: ["lit-gobo.fx16", "lit.fx16"],
  shadow: ["lit-shadow.fx16", "lit.fx16"],
  haze: ["haze.fx16"],
  dither: ["dither.fx16", "srgb.fx16"],
  "keep-hue": ["keep-hue.fx16", "clip.fx16"],
};

/**
 * The part of the list that is read.
 * @typedef {{ instructions: number, flash: number }} Price of a program
 * @typedef {Record<string, { figures: Record<string, Price | undefined> }>} List by processor
 */

/** What the numbers are, for people. */
export const MEANING = `Beside each switch: instructions for each light and pixel, and bytes of code, that it adds in 16 bits on a ${CHIP.words}.`;

/**
 * Loads the prices: a map from the name of a switch to what it adds to the program that it stands on,
 * beside it. Empty if the list does not load; the page works without it.
 */
export async function loadPrices() {
  /** @type {List | undefined} */
  let list;
  try {
    const answer = await fetch(new URL("prices.json", import.meta.url));
    if (!answer.ok) throw new Error(answer.statusText);
    list = await answer.json();
  } catch (error) {
    console.info(`The prices of the effects are not shown: ${error}`);
  }
  const prices = list?.[CHIP.name]?.figures ?? {};
  /** @type {[string, Price][]} */
  const told = Object.entries(PROGRAMS).flatMap(([effect, [program, over]]) => {
    const none = { instructions: 0, flash: 0 };
    const [price, base] = [prices[program], over === undefined ? none : prices[over]];
    if (!price || !base) return [];
    return [[effect, { instructions: price.instructions - base.instructions, flash: price.flash - base.flash }]];
  });
  return new Map(told);
}
