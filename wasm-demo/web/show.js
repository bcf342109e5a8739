// Starts the demo: loads the module and connects the views.
import init, { Stage } from "./pkg/wasm_demo.js";
import { Meter } from "./meter.js";
import { StagePage } from "./stage-page.js";
import { load, requestedSize } from "./support.js";
import { Views } from "./views.js";

/** Loads the module. The browser's own message for a failure is of little help by itself. */
async function start() {
  try {
    await init();
  } catch (error) {
    throw new Error(
      `The demo's WebAssembly module could not be loaded (${error.message}). ` +
        "Serve the whole folder, pkg included, over HTTP, and reload the page.",
    );
  }
}

/** Starts the demo. The other views are opened when they are first requested. */
export async function open() {
  await start();
  const { width, height } = requestedSize(location.search);
  const stage = new Stage(document.getElementById("view"), document.getElementById("map"), width, height);
  const page = new StagePage(stage);
  const meter = new Meter(stage, page);
  const comparison = {
    element: document.getElementById("comparison"),
    async open(attempt) {
      const { ComparisonView } = await load("comparison-view.js", attempt);
      return (meter.comparison = await ComparisonView.open());
    },
  };
  const chip = {
    element: document.getElementById("chip"),
    async open(attempt) {
      const { ChipView } = await load("chip-view.js", attempt);
      return (meter.chip = await ChipView.open());
    },
  };
  window.luminaire = meter;
  await new Views(
    new Map([
      ["stage", { element: document.getElementById("stage-page"), open: async () => page }],
      ["compare", comparison],
      ["chip", chip],
    ]),
  ).show();
}
