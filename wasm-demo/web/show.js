// Starts the demo: loads the module and connects the views.
import { initSync, Stage } from "./pkg/wasm_demo.js";
import { element } from "./elements.js";
import { notice } from "./failure.js";
import { Meter } from "./meter.js";
import { compile } from "./module.js";
import { Pool } from "./pool.js";
import { Screen } from "./screen.js";
import { StagePage } from "./stage-page.js";
import { load, requested } from "./support.js";
import { Views } from "./views.js";
import { cores } from "./workers.js";

/** Starts the demo. The other views are opened when they are first requested. */
export async function open() {
  const { width, height, workers = cores(), rests, refused } = requested(location.search);
  // Compiled once for the page and all workers, which load their scripts in the meantime.
  const compiling = compile(new URL("pkg/wasm_demo_bg.wasm", import.meta.url));
  const pool = new Pool(compiling, workers);
  const module = await compiling;
  const { memory } = initSync({ module });
  const stage = sized(width, height, refused);
  if (refused.length > 0) notice(`${refused.join(". ")}. The page goes on without that.`);
  const screen = new Screen(element("view", HTMLCanvasElement), element("map", HTMLCanvasElement));
  const page = new StagePage(stage, pool, screen, module, { rests });
  const meter = new Meter(stage, page, module, memory);
  const comparison = {
    element: element("comparison"),
    async open() {
      const { ComparisonView } = await load("comparison-view.js");
      return (meter.comparison = await ComparisonView.open());
    },
  };
  const museum = {
    element: element("museum"),
    async open() {
      const { MuseumView } = await load("museum-view.js");
      return (meter.museum = await MuseumView.open());
    },
  };
  const chip = {
    element: element("chip"),
    async open() {
      const { ChipView } = await load("chip-view.js");
      return (meter.chip = await ChipView.open());
    },
  };
  Object.assign(window, { luminaire: meter });
  await new Views(
    new Map([
      ["stage", { element: element("stage-page"), open: async () => page }],
      ["compare", comparison],
      ["museum", museum],
      ["chip", chip],
    ]),
  ).show();
}

/**
 * Returns the stage with pictures of a size, or without if the module refuses it.
 * @param {number | undefined} width
 * @param {number | undefined} height
 * @param {string[]} refused
 */
function sized(width, height, refused) {
  // One of them has been refused.
  if (refused.length > 0 && (width === undefined || height === undefined)) return new Stage();
  try {
    return new Stage(width, height);
  } catch (refusal) {
    if (typeof refusal !== "string") throw refusal;
    refused.push(refusal);
    return new Stage();
  }
}
