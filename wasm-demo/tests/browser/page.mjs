// The page in a browser: it fits every window, gestures end where they began, and nothing is refused
// that a control offers. `cargo xtask test --only "browser: the page"` runs it.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";

/** The address of the page, the browser's program, and the folder of the npm packages. */
const { PAGE, CHROMIUM, MODULES } = process.env;

const FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-dev-shm-usage",
  "--disable-background-networking",
  "--no-proxy-server",
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
];

/** Windows from a telephone, or a laptop at 400 %, to a large display, in pixels. */
const WIDTHS = [
  320, 360, 390, 412, 480, 600, 640, 700, 768, 820, 900, 1024, 1060, 1100, 1280, 1366, 1440, 1536, 1920, 2560,
];

/** The roles of what a visitor operates. */
const ROLES = [
  "application", "button", "checkbox", "ColorWell", "combobox", "link", "radio", "searchbox", "slider", "spinbutton",
  "textbox",
];

const VIEWS = ["compare", "museum", "chip"];

/** Small pictures, which the page draws itself. */
const SMALL = "?workers=0&rest=0&width=64&height=36";
const STILL = "#stage?scene=bare-spot&play=none";

let browser, tab;

before(async () => {
  const puppeteer = createRequire(`${MODULES}/`)("puppeteer-core");
  browser = await puppeteer.launch({ executablePath: CHROMIUM, args: FLAGS });
});
after(() => browser?.close());

/** Opens the page and waits for its first picture. */
async function open(address) {
  await tab?.close();
  tab = await browser.newPage();
  tab.setDefaultTimeout(60_000);
  await tab.setViewport({ width: 1280, height: 900 });
  await tab.goto(PAGE + address);
  await tab.waitForFunction(() => document.body.dataset.state !== "loading");
  assert.equal(await tab.evaluate(() => document.body.dataset.state), "ready", await words("failure"));
}

/** Goes to another state or view, and waits until it is shown. */
async function visit(hash) {
  await tab.evaluate((hash) => (location.hash = hash), hash);
  const view = hash.replace(/^#|\?.*/g, "");
  const shown = {
    stage: "#lights li",
    compare: "#ledger-title",
    museum: "#exhibit-list label",
    // Without npm the folder has no chip, and the page says so.
    chip: "#chip canvas, #absent-reason",
  };
  const isShown = (selector) => [...document.querySelectorAll(selector)].some((element) => element.checkVisibility());
  await tab.waitForFunction(isShown, {}, shown[view]);
  await settle();
}

/** Waits until nothing is drawn, the styles of the view are there and the address is written. */
async function settle() {
  const isStyled = () => [...document.querySelectorAll("link[rel=stylesheet]")].every((link) => link.sheet);
  await tab.waitForFunction(isStyled);
  await tab.waitForFunction(() => !window.luminaire.isDrawing);
  await tab.evaluate(() => new Promise((done) => setTimeout(() => requestAnimationFrame(done), 300)));
}

const words = (id) => tab.$eval(`#${id}`, (element) => element.textContent.trim());
const value = (id) => tab.$eval(`#${id}`, (input) => input.value);
const scenes = () => tab.$$eval("input[name=scene]", (inputs) => inputs.map((input) => input.value));
const angles = async () => [Number(await value("light-beam-number")), Number(await value("light-field-number"))];
const hash = () => tab.evaluate(() => location.hash);

/** Types into a field in place of what it holds, and leaves it. */
async function type(id, text) {
  await tab.focus(`#${id}`);
  await tab.$eval(`#${id}`, (input) => input.select());
  await tab.keyboard.type(text);
  await tab.keyboard.press("Tab");
}

const near = (found, expected) =>
  found.forEach((found, i) => assert.ok(Math.abs(found / expected[i] - 1) < 1e-3, `${found}: expected ${expected[i]}`));

/** A place of an element in the window, as shares of its width and height; else its middle. */
const place = (selector, at = [0.5, 0.5]) =>
  tab.$eval(
    selector,
    (element, [across, down]) => {
      element.scrollIntoView({ block: "center", behavior: "instant" });
      const { left, top, width, height } = element.getBoundingClientRect();
      return [left + across * width, top + down * height];
    },
    at,
  );

test("no name is over another and nothing scrolls sideways, from 320 to 2,560 pixels", async () => {
  await open(`${SMALL}${STILL}`);
  const states = (await scenes()).map((scene) => `stage?play=none&scene=${scene}`);
  for (const hash of [...states, "stage?play=none&scene=show&with=fx16&lights=0:i2073500", ...VIEWS]) {
    await visit(hash);
    for (const width of WIDTHS) {
      await tab.setViewport({ width, height: 900 });
      const faults = await tab.evaluate(() => {
        const wide = document.documentElement.scrollWidth;
        const names = [...document.querySelectorAll(".lights .name")].filter((name) => name.checkVisibility());
        const box = (element) => element.getBoundingClientRect();
        const tall = names.filter((name) => box(name).height > box(name.closest("li")).height);
        const over = names.filter((name, i) => i > 0 && box(names[i - 1]).bottom > box(name).top && box(names[i - 1]).right > box(name).left);
        const cut = [...document.querySelectorAll("input[type=number]")].filter((input) => input.scrollWidth > input.clientWidth);
        return [
          ...(wide > innerWidth ? [`${wide} pixels wide`] : []),
          ...[...tall, ...over].map((name) => `${name.textContent} is over another name`),
          ...cut.map((input) => `#${input.id} = ${input.value} is cut`),
        ];
      });
      assert.deepEqual(faults, [], `${hash}, in a window of ${width} pixels`);
    }
  }
});

test("12 and 22 degrees are typed in both orders, with every edge", async () => {
  await open(`${SMALL}${STILL}`);
  for (const edge of await tab.$$eval("#light-edge option", (options) => options.map((option) => option.value))) {
    for (const order of [[["beam", 12], ["field", 22]], [["field", 22], ["beam", 12]]]) {
      await tab.$eval("#reset", (button) => button.click());
      await tab.select("#light-edge", edge);
      for (const [name, degrees] of order) await type(`light-${name}-number`, String(degrees));
      near(await angles(), [12, 22]);
      assert.equal(await words("light-error"), "", edge);
    }
  }
  // What is typed is one step, and a refusal is read before it goes.
  await settle();
  await type("light-field-number", "15");
  await settle();
  await tab.click("#undo");
  near(await angles(), [12, 22]);
  await type("light-field-number", "400");
  assert.match(await words("light-error"), /^field angle = 400/);
  near(await angles(), [12, 22]);
});

test("a drag and a slider end where they began", async () => {
  await open(`${SMALL}#stage?scene=bare-spot&play=none&lights=0:b12:f22`);
  await tab.waitForSelector("#curve .handle");
  const flux = () => value("light-intensity-number");
  const before = await flux();
  // The dot of the beam angle: to the axis and back, in one drag.
  const [x, y] = await place("#curve .handle circle:nth-child(2)");
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  for (const share of [0.2, 0.4, 0.95, 0.5, 0]) {
    const across = await tab.$eval("#curve", (curve) => curve.getBoundingClientRect().left + curve.getBoundingClientRect().width * (240 / 440));
    await tab.mouse.move(x + share * (across - x), y, { steps: 2 });
  }
  await tab.mouse.up();
  const [beam, field] = await angles();
  assert.ok(Math.abs(beam - 12) < 0.1 && Math.abs(field - 22) < 0.01, `${beam} and ${field}`);
  // The slider of the beam angle: to its end and back.
  await type("light-beam-number", "12");
  near(await angles(), [12, 22]);
  await tab.focus("#light-beam");
  await tab.keyboard.press("Home");
  assert.ok((await angles())[1] < 1, "the field angle does not follow");
  await tab.$eval("#light-beam", (slider) => {
    slider.value = String(Math.log10(12));
    slider.dispatchEvent(new Event("input"));
  });
  near(await angles(), [12, 22]);
  near([Number(await flux())], [Number(before)]);
});

test("the wheel scrolls the page, unless the picture has the focus or with Ctrl", async () => {
  await open(`${SMALL}#stage?scene=show&play=none`);
  await tab.waitForSelector("#handle-aim:not([hidden])");
  const state = async () => (await settle(), hash());
  for (const target of ["#view", "#handles .area"]) {
    const before = await state();
    await tab.evaluate(() => (document.activeElement.blur(), scrollTo(0, 0)));
    await tab.mouse.move(...(await place(target)));
    await tab.evaluate(() => scrollTo(0, 0));
    await tab.mouse.wheel({ deltaY: 300 });
    await tab.waitForFunction(() => scrollY > 0);
    assert.equal(await state(), before, `the wheel over ${target} changes the state`);
  }
  const turn = (deltaY) => tab.$eval("#view", (view, deltaY) => view.dispatchEvent(new WheelEvent("wheel", deltaY)), deltaY);
  const [before, wheel] = [await state(), { deltaY: 100, bubbles: true, cancelable: true }];
  assert.ok(await turn(wheel));
  assert.ok(!(await turn({ ...wheel, ctrlKey: true })));
  const zoomed = await state();
  assert.notEqual(zoomed, before);
  await tab.focus("#view");
  assert.ok(!(await turn(wheel)));
  assert.notEqual(await state(), zoomed);
});

test("a touch that the browser takes leaves camera and lights as they were", async () => {
  await open(`${SMALL}#stage?scene=three-point&play=none`);
  await tab.waitForSelector("#handle-0:not([hidden])");
  const client = await tab.createCDPSession();
  const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  const places = [
    { target: "#view", at: [0.1, 0.9], changes: "&view=" },
    { target: "#handle-0", at: [0.5, 0.5], changes: "&lights=" },
    { target: "#exposure", at: [0.7, 0.5], changes: "&exposure=" },
  ];
  for (const { target, at, changes } of places) {
    await settle();
    const before = await hash();
    const [x, y] = await place(target, at);
    await touch("touchStart", { x, y });
    for (const way of [10, 20, 40]) await touch("touchMove", { x: x + way, y });
    await settle();
    assert.ok((await hash()).includes(changes), `a drag on ${target} leads to ${await hash()}`);
    await touch("touchCancel");
    await settle();
    assert.equal(await hash(), before, `a cancelled touch on ${target}`);
    assert.ok(await tab.$eval("#undo", (button) => button.disabled), "there is a step to undo");
  }
});

/** Moves sliders to both ends. Returns what is refused in one of these places. */
const turn = (sliders, places) =>
  tab.evaluate(
    (sliders, places) =>
      sliders.flatMap((id) => {
        const slider = document.getElementById(id);
        if (!slider.checkVisibility()) return [];
        slider.focus();
        return [slider.min, slider.max].flatMap((end) => {
          slider.value = end;
          slider.dispatchEvent(new Event("input"));
          const told = [...places, "trouble"].map((id) => document.getElementById(id).textContent).join("");
          return told ? [`${id} = ${end}: ${told}`] : [];
        });
      }),
    sliders,
    places,
  );

test("both ends of every slider are taken, in every scene and view", async () => {
  await open(`${SMALL}${STILL}`);
  await tab.waitForSelector("#curve .handle");
  for (const scene of await scenes()) {
    await tab.evaluate((hash) => (location.hash = hash), `stage?play=none&scene=${scene}`);
    await tab.waitForFunction((scene) => window.luminaire.scene === scene, {}, scene);
    const sliders = ["light-beam", "light-field", "light-intensity", "exposure"];
    assert.deepEqual(await turn(sliders, ["light-error", "stage-error"]), [], scene);
  }
  await visit("compare");
  assert.deepEqual(await turn(["half-angle"], ["half-angle-error"]), []);
  await visit("museum");
  for (const exhibit of await tab.$$eval("input[name=exhibit]", (inputs) => inputs.map(({ id }) => id))) {
    await tab.$eval(`#${exhibit}`, (input) => input.click());
    assert.deepEqual(await turn(["exhibit-value"], ["exhibit-error"]), [], exhibit);
  }
});

test("every control has a name, also while the picture plays", async () => {
  await open(`${SMALL}#stage?scene=show&play=both`);
  await tab.waitForSelector("#handle-aim");
  for (const view of ["", ...VIEWS]) {
    if (view) await visit(view);
    // The browser computes names some time after a change.
    let unnamed;
    for (let tries = 0; tries < 20 && unnamed?.length !== 0; tries += 1) {
      const all = (node) => [node, ...(node.children ?? []).flatMap(all)];
      const controls = all(await tab.accessibility.snapshot()).filter(({ role }) => ROLES.includes(role));
      assert.ok(controls.length > 4, `${view} has ${controls.length} controls`);
      unnamed = controls.filter(({ name }) => !name?.trim()).map(({ role, value }) => ({ role, value }));
    }
    assert.deepEqual(unnamed, [], `controls without a name in ${view || "stage"}`);
  }
  const aim = await tab.$eval("#handle-aim", (aim) => [aim.getAttribute("aria-label"), aim.getAttribute("aria-valuenow")]);
  assert.ok(aim.every(Boolean), `the aim is ${aim}`);
});

test("what an address asks in vain is told, and the page goes on", async () => {
  for (const [query, told] of [
    ["?width=abc&height=36", /^width = "abc": expected a whole number of pixels\./],
    ["?workers=99&rest=0&width=64&height=36", /^workers = "99": expected 0 to 16 workers\./],
    ["?workers=0&width=0&height=36", /^width = 0: expected 1 to 8192 pixels\./],
    ["?workers=0&width=64", /^height = 0: expected 1 to 8192 pixels\./],
    ["?workers=0&width=8192&height=8192", /^height = 8192: expected 1 to \d+ pixels\./],
  ]) {
    await open(query + STILL);
    assert.match(await words("trouble"), told);
    await tab.waitForFunction(() => window.luminaire.drawn > 0);
  }
  await open(`${SMALL}#stage?scene=three-point&play=none&lights=0:x;1:<img/src>;2&map=<img/src>`);
  assert.match(await words("stage-error"), /lights = "1:.*": expected a light of the scene.*subject of the map = /);
  assert.equal(await tab.$eval("#stage-error", (error) => error.children.length), 0);
  assert.equal(await words("lights-count"), "2 of 3 on");
});

test("title and focus follow the view", async () => {
  await open(`${SMALL}${STILL}`);
  const title = await tab.title();
  for (const [view, id] of [["compare", "comparison"], ["stage", "stage-page"]]) {
    await tab.click(`.views a[href="#${view}"]`);
    await tab.waitForSelector(`#${id}`, { visible: true });
    assert.equal(await tab.evaluate(() => document.activeElement.id), id);
    assert.equal((await tab.title()) === title, view === "stage", await tab.title());
  }
});
