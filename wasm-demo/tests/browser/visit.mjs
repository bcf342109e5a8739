// A visit of the page in a browser: opening it, waiting, and acting as a visitor does. The other files hold
// the tests, by what they promise. `cargo xtask test --only browser` runs the quick ones.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { setTimeout as pause } from "node:timers/promises";

import { PATIENCE, chromium, puppeteer } from "../../../xtask/browser/launch.mjs";
import { probe } from "./probe.mjs";
import { webkit } from "./webkit.mjs";

/** The address of the page, the engine, which tests run (quick, more or long), and a file of what the host expects. */
const { PAGE, FIREFOX, ENGINE = "Chromium", LEVEL = "quick", EXPECTED } = process.env;

export { ENGINE, PAGE, assert, pause };

/** What the host computes for the page, and the views that the page has. */
export const EXPECT = JSON.parse(readFileSync(EXPECTED, "utf8"));

export const VIEWS = EXPECT.views;

/** A scene of which nothing moves, where the mouse over the picture moves the camera alone. */
export const STILL = "#stage?scene=three-point&play=none&handles=0";

/** A quarter of the pixels of a visitor's picture, also at rest. */
export const SIZE = "?rest=0&width=480&height=270";

/** How long a wait may take on a busy machine, in milliseconds. */
const WAIT = 120_000;

/** The size of the window in pixels. */
const WINDOW = { width: 1440, height: 900 };

/** A page from a file may not read other files, as in a visitor's browser. */
const PREFERENCES = { "security.fileuri.strict_origin_policy": true };

const ENGINES = {
  Chromium: () => chromium(),
  Firefox: () =>
    puppeteer.launch({
      browser: "firefox",
      executablePath: FIREFOX,
      extraPrefsFirefox: PREFERENCES,
      defaultViewport: null,
      timeout: PATIENCE,
      protocolTimeout: 0,
    }),
  WebKit: webkit,
};

let browser, context, complaints, mayComplain;

/** The page that is open, of puppeteer or of the driver of WebKit. */
export let tab;

/** The addresses that the page has requested. */
export let requests;

before(async () => (browser = await ENGINES[ENGINE]()));
after(() => browser?.close());

/** Adds a test. A page that complains on its console fails it, unless `fails` says that it must. */
function promise(name, act, { only = ENGINE, fails = false } = {}) {
  if (only !== ENGINE) return;
  const visit = async () => {
    [complaints, mayComplain] = [[], fails];
    await act();
    await content();
    await close();
  };
  test(name, async () => {
    try {
      await visit();
    } catch (error) {
      // WebKitGTK was seen to crash once in four runs. A page that makes it crash does so again.
      if (!browser.hasCrashed || !(await browser.hasCrashed())) throw error;
      tab = undefined;
      browser = await ENGINES[ENGINE]();
      await visit();
    }
  });
}

/** Tests of every run. */
export const quick = promise;
/** Tests of a full run. */
export const more = LEVEL === "quick" ? () => {} : promise;
/** Long tests of a full run, in the first engine. */
export const long = LEVEL === "long" ? promise : () => {};

async function close() {
  if (tab) await (context ?? tab).close();
  tab = undefined;
}

/** Fails if the page has complained. */
async function content() {
  // What has happened before this call is known once it has an answer.
  await tab?.evaluate("0");
  if (!mayComplain) assert.deepEqual(complaints, [], "the page complains");
}

/**
 * Opens the page, in a context that shares nothing with others, and waits until it is ready and nothing is
 * drawn. `script` changes the browser before the page's own scripts run. A page that `plays` never comes to rest.
 */
export async function open(address = STILL, { script, plays = false, state = "ready", page = PAGE } = {}) {
  if (tab) await content();
  await close();
  context = await browser.createBrowserContext();
  tab = await context.newPage();
  requests = [];
  const complain = (words) => complaints.push(String(words));
  tab.on("request", (request) => requests.push(request.url()));
  tab.on("pageerror", (error) => complain(error?.stack ?? error));
  tab.on("console", (message) => ["error", "assert"].includes(message.type()) && complain(message.text()));
  tab.on("response", (response) => response.status() >= 400 && complain(`${response.status()} ${response.url()}`));
  await tab.evaluateOnNewDocument(probe);
  if (script) await tab.evaluateOnNewDocument(script);
  await tab.setViewport(WINDOW);
  await tab.goto(page + (address.startsWith("#") ? SIZE : "") + address, { waitUntil: "domcontentloaded", timeout: PATIENCE });
  await until(() => !["loading", undefined].includes(document.body?.dataset.state));
  const found = await ask(() => document.body.dataset.state);
  assert.equal(found, state, `${await words("failure")} ${complaints.join("\n")}`);
  if (!plays && state === "ready") await settle();
}

/** The value of a function, or of an expression, in the page. */
export const ask = (act, ...given) => tab.evaluate(act, ...given);

/** Waits until a function is true in the page. Returns its value. */
export async function until(holds, ...given) {
  const end = Date.now() + WAIT;
  for (;;) {
    const found = await ask(holds, ...given);
    if (found) return found;
    if (Date.now() > end) {
      throw new Error(`expected ${holds} of ${JSON.stringify(given)}, found ${found} after ${WAIT} ms\n${complaints.join("\n")}`);
    }
    await pause(20);
  }
}

/** Waits until the page has an element. An element itself is no value for every engine. */
export const exists = (selector) => until((selector) => document.querySelector(selector) !== null, selector);

/** Fails unless `is` accepts what was found. */
export const must = (found, is, expected) => assert.ok(is(found), `expected ${expected}, found ${JSON.stringify(found)}`);

/** Waits until the page has drawn nothing for a while. */
export const settle = () => ask(() => window.probe.settle());

/** Waits until the address is written, which is a while after the last change. */
export async function written() {
  await settle();
  await pause(600);
}

/** Waits until the address matches. Returns it. */
export const isWritten = (pattern) => until((pattern) => location.hash.match(pattern) && location.hash, pattern.source);

export const words = (id) => ask((id) => document.getElementById(id)?.textContent.trim() ?? "", id);
export const value = (id) => ask((id) => window.probe.element(id).value, id);
export const number = async (id) => Number(await value(id));
export const shows = (id) => ask((id) => window.probe.visible(id), id);
export const isChecked = (id) => ask((id) => window.probe.element(id).checked, id);
export const isDisabled = (id) => ask((id) => window.probe.element(id).disabled, id);
export const press = (id) => ask((id) => window.probe.element(id).click(), id);
export const focus = (id) => ask((id) => window.probe.element(id).focus(), id);
export const options = (id) => ask((id) => Array.from(window.probe.element(id).options, ({ value }) => value), id);
export const count = (selector) => ask((selector) => document.querySelectorAll(selector).length, selector);
export const hash = () => ask(() => location.hash);
export const drawn = () => ask(() => window.luminaire.drawn);
export const account = () => ask(() => window.luminaire.account);
/** The number of pixels, the share of them that is not black, and the number of colours. */
export const survey = () => ask(() => window.probe.survey());
/** A sum of the picture: two pictures hardly ever have the same. */
export const sum = () => ask(() => window.probe.sum());
/** Waits until the picture is lit. */
export const isLit = async (what) => must((await survey()).lit, (lit) => lit > 0, `${what}: a picture that is not black`);

/** Waits until something is seen. */
export const isShown = (id) => until((id) => document.getElementById(id) && window.probe.visible(id), id);

/** Enters a value as a visitor does by typing, sliding or choosing. */
export async function enter(id, value) {
  await ask((id, value) => window.probe.enter(id, value), id, String(value));
  await settle();
}

/** Types into a field in place of what it holds, and leaves it. */
export async function type(id, text) {
  await ask((id) => (window.probe.element(id).focus(), window.probe.element(id).select()), id);
  await tab.keyboard.type(text);
  await tab.keyboard.press("Tab");
}

/** Waits until a view has loaded and shows what it is about. */
export async function isOpen(view) {
  const shown = { stage: "#lights li", compare: "#name-0:not(:empty)", museum: "#exhibit-title:not(:empty)", class: "#class-title:not(:empty)", chip: "#chip canvas", use: "#use-code:not(:empty)" };
  await until((selector) => [...document.querySelectorAll(selector)].some((found) => found.checkVisibility()), shown[view]);
  await settle();
}

/** Goes to a state or a view by its address. */
export async function go(hash) {
  await ask((hash) => void (location.hash = hash), hash);
  await isOpen(hash.replace(/^#|\?.*/g, ""));
}

/** Follows a link of the navigation. */
export const follow = (view) => ask((view) => document.querySelector(`.views a[href^="#${view}"]`).click(), view);

/** Chooses a scene. */
export async function choose(scene) {
  await press(`scene-${scene}`);
  await settle();
}

export const scenes = () => ask(() => Array.from(document.querySelectorAll("input[name=scene]"), ({ value }) => value));

/** The middle of an element in the window, scrolled into view, or a place as shares of its width and height. */
export const place = (selector, at = [0.5, 0.5]) =>
  ask(
    (selector, [across, down]) => {
      const element = document.querySelector(selector);
      element.scrollIntoView({ block: "center", behavior: "instant" });
      const { left, top, width, height } = element.getBoundingClientRect();
      return [left + across * width, top + down * height];
    },
    selector,
    at,
  );

/** Presses the mouse's main button at a place, moves it along, and lets go. */
export async function drag([x, y], [right, down]) {
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + right, y + down, { steps: 8 });
  await tab.mouse.up();
}

/** Acts, which must let the page draw. */
export async function redraw(what, act) {
  const before = await drawn();
  await act();
  try {
    await until((before) => window.luminaire.drawn !== before, before);
  } catch (error) {
    throw new Error(`${what} draws no picture`, { cause: error });
  }
  await settle();
}

/** Acts, which must change the picture. */
export async function change(what, act) {
  const before = await sum();
  await redraw(what, act);
  assert.notEqual(await sum(), before, `${what} leaves the picture as it was`);
}

/** Waits for a picture after those of now. */
export const draws = async (more) => until((least) => window.luminaire.drawn > least, (await drawn()) + more);

/** Gives the window a size, on a device with `density` pixels along each of its pixels. */
export const resize = (width, height, density = 1) => tab.setViewport({ width, height, deviceScaleFactor: density });

/** Fails unless the demo takes input and shows a picture. */
export async function works() {
  const state = await ask(() => [document.body.dataset.state, document.querySelector("main").inert]);
  assert.deepEqual(state, ["ready", false], await words("failure"));
  if (await shows("view")) await isLit("a page that works");
}

/** Drops a file, by default one of other tools that the reader's tests have, and waits until it is shown or refused. */
export async function give(name, text = readFileSync(new URL(`../../../exchange/tests/files/${name}`, import.meta.url), "utf8")) {
  await ask((name, text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, name, text);
  await until(() => !document.getElementById("file-told").textContent.startsWith("Reading"));
}

/** Shows the price, which is loaded when it is in view. */
export async function openPrice() {
  await press("tab-price");
  await ask(() => document.getElementById("price").scrollIntoView());
  await exists("#price-picked b");
}

/** Opens every panel and drawer, also those that are loaded when they are in view. */
async function openAll() {
  await openPrice();
  await press("tab-lights");
  await give("spot.ies");
  await ask(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
  await until(() => [...document.querySelectorAll("details pre")].every((pre) => pre.textContent));
}

/** Runs the board until it has shown a picture, and stops it. */
async function runBoard() {
  await until(() => window.luminaire.chip?.drawn > 0);
  await press("chip-run");
  await until(() => document.getElementById("chip-state").textContent.trim() === "The chip waits.");
}

/** The stage with all panels open. */
export const EVERY_PANEL = { name: "every panel open", address: "#stage?scene=three-point&play=none&format=fx16", act: openAll };

/** Every view, the stage and the comparison in each of their modes. */
export const STATES = [
  { name: "the show", address: "#stage?scene=show&play=none" },
  EVERY_PANEL,
  { name: "the settings of the picture", address: "#stage?scene=three-point&play=none&map=lights&with=fx16", act: () => press("tab-picture") },
  { name: "what was evaluated", address: "#stage?scene=three-point&play=none", act: () => press("tab-work") },
  { name: "the price", address: "#stage?scene=three-point&play=none&format=fx16", act: openPrice },
  { name: "a refused address", address: "#stage?scene=three-point&play=none&lights=0:b0.1&format=fx16" },
  { name: "a refused angle", address: "#stage?scene=three-point&play=none", act: () => enter("light-beam-number", 1000) },
  { name: "a divided picture", address: "#stage?scene=pocket&play=none", act: () => enter("divided-format", "fx16") },
  { name: "the map of lights", address: "#stage?scene=pocket&play=none&map=lights" },
  { name: "the map of costs", address: "#stage?scene=pocket&play=none&map=cost" },
  { name: "the map of tiles", address: "#stage?scene=pocket&play=none&map=tiles" },
  { name: "the comparison", address: "#compare?left=fx16&half=10" },
  { name: "a refused form", address: "#compare?left=fx16&half=0.1" },
  { name: "the museum", address: "#museum", act: () => enter("exhibit-number", 1000) },
  { name: "the class", address: "#class?figure=both&beam=8&field=140" },
  { name: "the chip", address: "#chip", act: runBoard },
  { name: "the use", address: "#use" },
].filter(({ address }) => VIEWS.includes(address.match(/\w+/)[0]));

/** Opens the page in a state. */
export async function show({ address, act }) {
  await open(address);
  await act?.();
  await settle();
}
