// Starts the demo: loads the module and connects the parts of the page.
import init, { Demo } from "./pkg/wasm_demo.js";
import { Curve } from "./curve.js";
import { aside } from "./failure.js";
import { FormatPicker } from "./format-picker.js";
import { LightDesk } from "./light-desk.js";
import { Meter } from "./meter.js";
import { Readout } from "./readout.js";
import { StageView } from "./stage-view.js";
import { load, requestedSize } from "./support.js";
import { Sweep } from "./sweep.js";
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

/** Duration of the warm-up, in milliseconds. */
const WARM_UP = 400;

/**
 * Draws a few pictures more than the visitor needs. The browser has not optimised the code of the
 * first pictures in a new format, and the readout must not keep their times.
 */
async function warmUp(meter) {
  const end = Date.now() + WARM_UP;
  while (Date.now() < end) await meter.measure(1);
}

/** Starts the demo. Order of connection: the views, the controls, the displays. */
export async function open() {
  await start();
  const { width, height } = requestedSize(location.search);
  const canvas = document.getElementById("view");
  const demo = new Demo(canvas, width, height);
  const view = new StageView(demo, canvas);
  const readout = new Readout(demo);
  const curve = new Curve(demo);
  const desk = new LightDesk(demo);
  const formats = new FormatPicker(demo, desk);
  const sweep = new Sweep(demo);
  const meter = new Meter(demo, view, formats);

  view.before((now) => sweep.step(now));
  view.after(() => readout.add());
  const drawCurve = (light) => aside(() => curve.draw(light));
  desk.onselect = drawCurve;
  desk.onchange = (light) => {
    formats.retry();
    drawCurve(light);
    view.request();
  };
  formats.onchange = () => {
    readout.forget();
    desk.refresh();
    drawCurve(desk.selected);
    warmUp(meter);
  };
  sweep.onchange = () => view.request();

  desk.select(0);
  formats.show();
  // Nothing moves yet, so that the order does not matter here.
  view.draw(0);
  await warmUp(meter);
  window.luminaire = meter;
  await views(view, meter).show();
}

/** The stage; and the comparison and the scenes, which are opened when they are first requested. */
function views(view, meter) {
  const stage = {
    element: document.getElementById("stage-page"),
    open: async () => ({ show: () => view.pause(false), hide: () => view.pause(true) }),
  };
  const comparison = {
    element: document.getElementById("comparison"),
    async open(attempt) {
      const { ComparisonView } = await load("comparison-view.js", attempt);
      return (meter.comparison = await ComparisonView.open());
    },
  };
  const scenes = {
    element: document.getElementById("scenes-page"),
    async open(attempt) {
      const { ScenesView } = await load("scenes-view.js", attempt);
      return (meter.scenes = new ScenesView());
    },
  };
  const all = new Views(new Map([["stage", stage], ["compare", comparison], ["scenes", scenes]]));
  meter.openScenes = async () => {
    await all.show({ name: "scenes", query: new URLSearchParams() });
    return meter.scenes;
  };
  return all;
}
