// Everybody can use the page: by the keyboard alone, with a screen reader, and with forced colours.
import { readFileSync } from "node:fs";
import { join } from "node:path";

import { serveParts } from "./building.mjs";
import {
  EVERY_PANEL, STATES, STILL, VIEWS, ask, assert, exists, follow, isOpen, isShown, long, more, must, open, press, quick, redraw, resize, settle,
  show, tab, until,
} from "./visit.mjs";

/** axe-core finds no fault: neither against the criteria of WCAG 2.2, A and AA, nor against best practice. */
async function axeFindsNothing(place) {
  const axe = readFileSync(join(process.env.MODULES, "axe-core/axe.min.js"), "utf8");
  if (!(await ask(() => Boolean(window.axe)))) await ask(`${axe}; 0`);
  const { passes, violations } = await ask(async () => {
    const runOnly = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
    const { passes, violations } = await window.axe.run({ runOnly, resultTypes: ["violations"] });
    const told = ({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${id} at ${target.join(" ")}: ${failureSummary}`);
    return { passes: passes.length, violations: violations.flatMap(told) };
  });
  must(passes, () => passes > 20, `${place}: over 20 rules that pass`);
  assert.deepEqual(violations, [], place);
}

quick("axe-core finds no fault in the views", async () => {
  await show(EVERY_PANEL);
  await resize(1280, 900);
  for (const view of VIEWS) {
    await follow(view);
    await isOpen(view);
    await axeFindsNothing(view);
  }
});

quick("axe-core finds no fault in a view that is being built, or could not be", async () => {
  const { address, end } = await serveParts({ class: "building", comparison: "no memory" });
  try {
    await open("#class", { page: address });
    await isShown("waiting");
    await axeFindsNothing("a view that is being built");
    await follow("compare");
    await isShown("absent");
    await axeFindsNothing("a view that could not be built");
  } finally {
    end();
  }
});

long("axe-core finds no fault in any state, on a laptop and on a telephone", async () => {
  for (const state of STATES) {
    await show(state);
    for (const width of [1280, 390]) {
      await resize(width, 900);
      await settle();
      await axeFindsNothing(`${state.name}, ${width} pixels wide`);
    }
  }
});

more("sliders in the picture tell their place within their ends, also below 0", async () => {
  await open("#stage?scene=bare-spot&play=none");
  await redraw("the light put far away", () => ask(() => {
    const x = document.getElementById("light-x");
    x.value = "-20";
    x.dispatchEvent(new Event("input", { bubbles: true }));
  }));
  const told = await ask(() => [...document.querySelectorAll("[role=slider]")].map((slider) =>
    ["min", "now", "max"].map((name) => Number(slider.getAttribute(`aria-value${name}`) ?? NaN))));
  must(told, (told) => told.length > 2 && told.some(([, now]) => now === -20), "sliders, one of them at -20");
  for (const [least, now, most] of told) must([least, now, most], () => least <= now && now <= most, "a value between its ends");
});

more("keys do what the mouse does in the picture", async () => {
  await open("#stage?scene=bare-spot&play=none");
  const [picture, number] = [() => window.probe.sum(), (id) => `Number(document.getElementById("light-${id}").value)`];
  for (const [what, selector, key, shiftKey, changes] of [
    ["orbit", "#view", "ArrowLeft", false, picture],
    ["come closer", "#view", "+", false, picture],
    ["go away", "#view", "-", false, picture],
    ["raise a light", "#handle-0", "ArrowUp", false, number("y")],
    ["move a light at its height", "#handle-0", "ArrowUp", true, number("z")],
    ["aim a light", "#handle-aim", "ArrowRight", false, number("aim-x")],
    ["widen a pool", "#handle-aim", "+", false, number("field-number")],
    ["narrow a pool", "#handle-aim", "-", false, number("field-number")],
    ["set an angle", "#curve [role=slider]", "ArrowRight", false, number("beam-number")],
    ["reset the camera", "#view", "r", false, picture],
  ]) {
    await exists(selector);
    const before = await ask(changes);
    const isFocused = (selector) => (document.querySelector(selector).focus(), document.activeElement === document.querySelector(selector));
    assert.ok(await ask(isFocused, selector), `${selector} takes no focus`);
    const type = (selector, options) => void window.probe.key(document.querySelector(selector), options);
    await redraw(`the key to ${what}`, () => ask(type, selector, { key, shiftKey }));
    assert.notEqual(await ask(changes), before, `the key to ${what} changes nothing`);
  }
});

/** What is seen of an element and a margin around it. The page keeps the pixels of the last two. */
async function seen(selector, margin = 0) {
  const clip = await ask((selector, margin) => window.probe.place(selector, margin), selector, margin);
  return ask((png) => window.probe.look(png), await tab.screenshot({ clip, captureBeyondViewport: false, encoding: "base64" }));
}

/**
 * Follows the Tab key from the first control of the page on. It must reach every control. `look` is called at each,
 * which has the attribute `data-seen`, or the label of a radio button.
 */
async function walk(place, look) {
  // Of a group of radio buttons the Tab key reaches the checked one, and of tabs the chosen one.
  const stops = await ask(() => {
    const all = document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex="-1"])');
    const isSeen = (stop) => stop.getClientRects().length > 0 && stop.checkVisibility({ visibilityProperty: true });
    window.stops = [...all].filter((stop) => !stop.disabled && stop.tabIndex >= 0 && isSeen(stop) && (stop.type !== "radio" || stop.checked));
    window.reached = new Set();
    window.stops[0].focus();
    return window.stops.length;
  });
  must(stops, () => stops > 5, `${place}: over 5 controls`);
  // Also the parts that scroll are stops.
  for (let stop = 0; stop < stops + 20; stop += 1) {
    if (await ask(() => window.reached.size > 0 && document.activeElement === window.stops[0])) break;
    const name = await ask(() => {
      const focused = document.activeElement;
      if (focused === document.body) return null;
      document.querySelector("[data-seen]")?.removeAttribute("data-seen");
      (focused.matches(".unseen") ? focused.parentElement : focused).setAttribute("data-seen", "");
      window.reached.add((window.focused = focused));
      return focused.id || focused.textContent.trim() || focused.outerHTML.slice(0, 120);
    });
    if (name !== null) await look?.(name);
    await tab.keyboard.press("Tab");
  }
  const missed = () => window.stops.filter((stop) => !window.reached.has(stop)).map((stop) => stop.id || stop.outerHTML);
  assert.deepEqual(await ask(missed), [], `${place}: controls that are not reached`);
}

quick("the stage is used by the keyboard alone", async () => {
  await open("#stage?play=none&scene=turntable");
  await isShown("handle-aim");
  await walk("the turntable");
});

long("the keyboard reaches every control, and shows where it is", async () => {
  for (const state of STATES) {
    await show(state);
    await walk(state.name, async (name) => {
      await seen("[data-seen]", 6);
      await ask(() => window.focused.blur());
      const { differing } = await seen("[data-seen]", 6);
      must(differing, () => differing > 30, `${state.name}: over 30 pixels that show the focus of ${name}`);
      await ask(() => window.focused.focus());
    });
  }
});

/** Opens the page as for a visitor whose system forces its colours on every page. */
async function openForced(address) {
  await open(address);
  const client = await tab.createCDPSession();
  await client.send("Emulation.setEmulatedMedia", { features: [{ name: "forced-colors", value: "active" }] });
}

const sliderIsSeen = async (selector) => must((await seen(selector)).share, (share) => share > 0.9, `over 0.9 of ${selector} to be seen`);

/** On and off are seen, and differ. */
async function switchIsSeen(id) {
  const before = await seen(`#${id}`);
  await press(id);
  // Waits until the thumb has moved.
  await settle();
  const after = await seen(`#${id}`);
  for (const { share } of [before, after]) must(share, () => share > 0.2, `over 0.2 of the switch ${id} to be seen`);
  assert.deepEqual(after.ground, before.ground, `the ground of the switch ${id}`);
  must(after, ({ differing, pixels }) => 10 * differing > pixels, `on and off of ${id} to differ in a tenth of the pixels`);
}

/** The frame of what is chosen is seen, and others have none. */
async function frameIsSeen(choice) {
  const frames = [await seen(`${choice}:has(:checked)`), await seen(`${choice}:not(:has(:checked))`)].map(({ top }) => top);
  assert.deepEqual(frames, [true, false], `the frames of ${choice}`);
}

long("forced colours hide nothing", async () => {
  await openForced(STILL);
  await sliderIsSeen("#light-beam");
  await switchIsSeen("light-2-on");
  for (const [chosen, other] of [["#lights li:nth-child(1)", "#lights li:nth-child(2)"], [".views [aria-current]", ".views a:not([aria-current])"]]) {
    assert.notDeepEqual((await seen(chosen)).ground, (await seen(other)).ground, `${chosen} looks like ${other}`);
  }
  await frameIsSeen(".picker label");
  await press("tab-picture");
  await sliderIsSeen("#exposure");
  await switchIsSeen("handles-shown");
  await press("tab-lights");
  const style = (selector, property) => ask((selector, property) => getComputedStyle(document.querySelector(selector))[property], selector, property);
  assert.notEqual(await style("#curve .angle", "fill"), await style(".desk", "backgroundColor"), "the labels of the curve");
  await openForced("#stage?play=none&scene=show");
  await press("tab-work");
  // The frame, what was evaluated, and two kinds of what was left out.
  must((await seen(".bar")).colours, (colours) => colours > 3, "at least four colours in the bar of what was evaluated");
  await openForced("#compare");
  await sliderIsSeen("#half-angle");
  await openForced("#museum");
  await sliderIsSeen("#exhibit-value");
  await frameIsSeen(".exhibits label");
  if (!VIEWS.includes("chip")) return;
  await openForced("#chip");
  await until(() => window.luminaire.chip?.drawn > 0);
  await switchIsSeen("chip-run");
  must((await seen("#chip-stages td")).colours, (colours) => colours > 1, "two colours in the bar of a stage");
});
