// The fixtures to choose from.
import { Stage } from "./pkg/wasm_demo.js";
import { made } from "./elements.js";
import { tidy, whole } from "./numbers.js";

/** @type {Record<string, string>} */
const KINDS = {
  beam: "narrow beam",
  profile: "profile spot",
  fresnel: "Fresnel or plano-convex",
  par: "PAR",
  spot: "moving or scanning spot",
  wash: "wash",
  flood: "flood or blinder",
};

/** @typedef {ReturnType<typeof described>} Fixture */

/** @type {Map<string, Fixture> | undefined} */
let fixtures;

/** The table, read from the module once. */
function table() {
  fixtures ??= new Map(Stage.fixtures().map((fixture) => [fixture.name, described(fixture)]));
  return fixtures;
}

/** @param {import("./pkg/wasm_demo.js").FixtureState} fixture */
function described(fixture) {
  const { name, kind, narrow: least, wide: most, lumens } = fixture;
  const [narrow, wide] = [tidy(least), tidy(most)];
  const angle = narrow === wide ? `${narrow}°` : `${narrow}–${wide}°`;
  const flux = lumens === undefined ? "" : `${whole(lumens)} lm`;
  return { name, kind, narrow, wide, angle, flux };
}

/**
 * The fixture of this name, or undefined.
 * @param {string} name
 */
export const findFixture = (name) => table().get(name);

/**
 * Fills a list with all fixtures and what a visitor may search for. Returns their number.
 * @param {HTMLElement} list
 */
export function listFixtures(list) {
  /** @type {(fixture: Fixture) => HTMLOptionElement} */
  const option = ({ name, kind, angle, flux }) =>
    made("option", { value: name, label: [name, angle, flux, KINDS[kind]].filter((part) => part).join(", ") });
  list.replaceChildren(...[...table().values()].map(option));
  return table().size;
}
