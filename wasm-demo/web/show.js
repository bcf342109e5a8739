// Starts the demo: loads the module and connects the views.
import { initSync, Stage } from "./pkg/wasm_demo.js";
import { element } from "./elements.js";
import { notice, refusalOf } from "./failure.js";
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
  const loaded = element("loaded", HTMLProgressElement);
  const compiling = compile(new URL("pkg/wasm_demo_bg.wasm", import.meta.url), (bytes) => (loaded.value = bytes));
  const pool = new Pool(compiling, workers);
  const module = await compiling;
  const { memory } = initSync({ module });
  const stage = sized(width, height, refused);
  if (refused.length > 0) notice(`${refused.join(". ")}. The page goes on without that.`);
  const screen = new Screen(element("view", HTMLCanvasElement), element("map", HTMLCanvasElement));
  const page = new StagePage(stage, pool, screen, module, { rests });
  const meter = new Meter(stage, page, module, memory);
  /**
   * A view that is loaded when it is opened, and that the meter then knows.
   * @type {(id: "comparison" | "museum" | "class" | "chip", name: string, part: import("./parts.js").Name) => import("./views.js").Source}
   */
  const late = (id, name, part) => ({
    element: element(id),
    part,
    open: async () => (meter[id] = await (await load(`${id}-view.js`))[name].open()),
  });
  Object.assign(window, { luminaire: meter });
  const views = new Views(
    new Map([
      ["stage", { element: element("stage-page"), open: async () => page }],
      ["compare", late("comparison", "ComparisonView", "comparison")],
      ["museum", late("museum", "MuseumView", "comparison")],
      ["class", late("class", "ClassView", "class")],
      ["chip", late("chip", "ChipView", "chip")],
      ["use", { element: element("use"), part: "code", open: async () => (await load("use-view.js")).UseView.open(() => page.selected) }],
    ]),
  );
  // A view that is still being built keeps nobody from the others.
  await Promise.race([views.show(), new Promise((resolve) => (views.onwait = () => resolve(undefined)))]);
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
  /** @type {Stage | undefined} */
  let stage;
  const refusal = refusalOf(() => (stage = new Stage(width, height)));
  if (refusal !== "") refused.push(refusal);
  return stage ?? new Stage();
}
