// The fixtures to choose from, grouped by what they are.
import { Stage } from "./pkg/wasm_demo.js";
import { tidy } from "./numbers.js";

const KINDS = {
  beam: "Narrow beams",
  profile: "Profile spots",
  fresnel: "Fresnels and plano-convex",
  par: "PARs",
  spot: "Moving and scanning spots",
  wash: "Washes",
  flood: "Floods and blinders",
};

let fixtures;

/** The table, read from the module once. */
function table() {
  fixtures ??= new Map(Stage.fixtures().map((fixture) => [fixture.name, plain(fixture)]));
  return fixtures;
}

function plain(fixture) {
  const { name, kind, narrow: least, wide: most, lumens } = fixture;
  const [narrow, wide] = [tidy(least), tidy(most)];
  const angle = narrow === wide ? `${narrow}°` : `${narrow}–${wide}°`;
  const flux = lumens === undefined ? "" : `${Math.round(lumens).toLocaleString("en")} lumens. `;
  fixture.free();
  return { name, kind, narrow, wide, angle, flux };
}

/** The fixture of this name, or undefined. */
export const findFixture = (name) => table().get(name);

/** Fills a select with all fixtures; its first option is none. */
export function listFixtures(select) {
  select.add(new Option("None: angles set by hand", ""));
  for (const [kind, label] of Object.entries(KINDS)) {
    const group = document.createElement("optgroup");
    group.label = label;
    for (const fixture of table().values()) {
      if (fixture.kind === kind) group.append(new Option(`${fixture.name}  (${fixture.angle})`, fixture.name));
    }
    select.append(group);
  }
}
