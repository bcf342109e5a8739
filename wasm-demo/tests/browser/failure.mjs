// The page shows what fails, which stops only what depends on it; and the page needs and requests nothing beside its
// own folder, which works on any host. A failure may be written to the console, so that its tests look at what is seen.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

import { serveParts } from "./building.mjs";
import {
  EXPECT, STILL, VIEWS, ask, assert, change, enter, exists, follow, go, hash, isLit, isOpen, isShown, more, must, open, pause, press,
  quick, requests, settle, shows, sum, tab, until, value, words, works, written,
} from "./visit.mjs";

/** A small picture, which the page draws itself. */
const SMALL = "?workers=0&rest=0&width=64&height=36";

const MAY_COMPLAIN = { fails: true };

/** The page must fail, and say so where it is seen. */
async function fails(told, address, more) {
  await open(address, { state: "failed", ...more });
  assert.match(await words("failure"), told);
  assert.ok(await shows("failure"), "the message is not seen");
}

quick("a browser without a canvas gets a message", () => fails(/canvas/i, STILL, { script: "HTMLCanvasElement.prototype.getContext = () => null" }), MAY_COMPLAIN);

more("a browser without simd gets a message", () => fails(/simd/i, STILL, { script: "WebAssembly.validate = () => false" }), MAY_COMPLAIN);

more("a page that is opened as a file says so", () => fails(/cargo demo/, "", { page: `file://${join(EXPECT.site, "index.html")}` }), MAY_COMPLAIN);

const OTHERS = Object.entries({ compare: "comparison", museum: "museum", class: "class", chip: "chip" }).filter(([view]) => VIEWS.includes(view));

const LOST = /could not be loaded.*connection/s;

quick(
  "a lost connection keeps views from opening, until it is back",
  async () => {
    await open();
    await tab.setOfflineMode(true);
    for (const [view, id] of OTHERS) {
      await follow(view);
      await isShown("absent");
      assert.match(await words("absent-reason"), LOST);
      assert.ok(!(await shows(id)), `${view} is shown although it was not loaded`);
      // A retry without a connection fails again.
      await press("absent-retry");
      await isShown("absent");
    }
    await follow("stage");
    await settle();
    assert.deepEqual([await shows("view"), await shows("absent")], [true, false], "the stage");
    await change("a beam, offline", () => enter("light-beam-number", 15));
    await works();
    await press("tab-price");
    await exists("#price > button");
    assert.match(await words("price"), /could not be loaded/);
    await tab.setOfflineMode(false);
    await ask(() => document.querySelector("#price > button").click());
    await exists("#price-picked b");
    for (const [view, id] of OTHERS) {
      await follow(view);
      await until((id) => window.luminaire[id] && window.probe.visible(id), id);
      assert.ok(!(await shows("absent")), `${view} is shown, and is said to be absent`);
    }
  },
  MAY_COMPLAIN,
);

more(
  "the formats of 32 bits are loaded when one is chosen, or that is told",
  async () => {
    // Without what the page does when the visitor pauses (`PAUSE` of verdict.js): it compares the picture with one in
    // 32 bits.
    await open(STILL, { script: "window.setTimeout = ((wait) => (act, time) => time === 600 ? 0 : wait(act, time))(window.setTimeout.bind(window))" });
    assert.deepEqual(requests.filter((name) => name.includes("wide")), [], "files that are loaded before a picture in 32 bits");
    await tab.setOfflineMode(true);
    const before = await sum();
    await enter("format", "f32");
    await until(() => document.getElementById("stage-error").textContent);
    assert.match(await words("stage-error"), LOST);
    await works();
    // The control, the address and the picture agree.
    await written();
    assert.deepEqual([await value("format"), (await hash()).includes("format"), await sum()], ["fx16", false, before]);
    await change("a beam, offline", () => enter("light-beam-number", 15));
    await tab.setOfflineMode(false);
    await change("32 bits, with a connection", () => enter("format", "f32"));
    assert.equal(await words("stage-error"), "");
    await works();
  },
  MAY_COMPLAIN,
);

quick(
  "a link in 32 bits is drawn in 16 where their module is missing, and says so",
  async () => {
    const script = `{ const { fetch } = window; window.fetch = (what, ...more) => String(what).endsWith("wide_bg.wasm") ? Promise.reject(new TypeError("no module")) : fetch(what, ...more); }`;
    await open(`${STILL}&format=f32&with=fx32`, { script });
    await until(() => document.getElementById("stage-error").textContent);
    await works();
    assert.match(await words("stage-error"), /could not be loaded \(no module\)\. The picture is in 16 bits\./);
    assert.deepEqual([await value("format"), await value("divided-format"), await shows("divided")], ["fx16", "", false]);
    await written();
    assert.equal((await hash()).includes("fx32"), false);
  },
  MAY_COMPLAIN,
);

quick("pictures are drawn again on canvases that the browser has emptied", async () => {
  /** Empties all canvases as a browser that has lost its graphics processor does. Returns those that stay empty. */
  const lose = () =>
    ask(async () => {
      // A view may put other canvases in their place.
      const shown = () => [...document.querySelectorAll("canvas")].filter((canvas) => canvas.checkVisibility() && canvas.width > 0);
      const sum = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, code) => (31 * sum + code) % 4294967291, 7);
      const before = shown().map(sum);
      for (const canvas of shown()) canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
      for (const canvas of shown()) canvas.dispatchEvent(new Event("contextrestored"));
      const lost = () => shown().filter((canvas, i) => sum(canvas) !== before[i]);
      for (let tries = 0; tries < 200 && lost().length > 0; tries += 1) await new Promise((resolve) => setTimeout(resolve, 50));
      return lost().map((canvas) => canvas.id || canvas.parentElement.textContent);
    });
  for (const view of ["stage?scene=three-point&play=none&map=lights&with=fx16&difference=1", ...VIEWS.filter((view) => !["stage", "use", "chip"].includes(view))]) {
    await open(`${SMALL}#${view}`);
    await isOpen(view.split("?")[0]);
    // Small pictures are drawn one at a time.
    await pause(1000);
    assert.deepEqual(await lose(), [], view);
  }
});

// The page while the demo is still being built.

/** Waits until an element has a text. */
const tells = (id, pattern) => until((id, pattern) => new RegExp(pattern, "s").test(document.getElementById(id).textContent), id, pattern);

quick(
  "what is still being built says so, and opens by itself",
  async () => {
    const states = { wide: "waiting", price: "waiting", code: "waiting", comparison: "no memory", class: "building", files: "waiting", chip: "waiting" };
    const { address, end } = await serveParts(states);
    try {
      // A deep link opens the page, and its view later.
      await open("#class?figure=cones", { page: address });
      await tells("waiting", "^The class is being built: 1 of 8 parts is ready");
      assert.deepEqual([await shows("class"), await shows("absent")], [false, false]);
      await go(STILL);
      assert.equal(await words("waiting"), "");
      const picture = await sum();
      // The formats of 32 bits are drawn in 16 bits until they are built.
      await enter("format", "f32");
      await tells("verdict-text", "32-bit renderer is not built yet.* in 16 bits");
      assert.deepEqual([await sum(), await words("stage-error"), await shows("beside")], [picture, "", false]);
      await change("a beam", () => enter("light-beam-number", 15));
      await change("the beam before", () => press("undo"));
      assert.equal(await sum(), picture);
      await works();
      // Panels and drawers.
      await ask(() => document.querySelector("#code summary").click());
      await tells("code-told", "^The code exporter is not built yet");
      await press("tab-price");
      await tells("price", "^The price is not built yet");
      states.wide = "built";
      await until((before) => window.probe.sum() !== before, picture);
      await tells("verdict-text", "differ from 32-bit floats");
      // A part that has failed leaves the others as they are, and opens once it is built.
      await follow("compare");
      await isShown("absent");
      assert.match(await words("absent-reason"), /could not be built: no memory\. Run `cargo demo` again.*other views still work/s);
      states.comparison = "building";
      await press("absent-retry");
      await tells("waiting", "^The comparison with f64 is being built");
      assert.ok(!(await shows("absent")));
      await follow("class");
      await tells("waiting", "^The class");
      assert.equal(await ask(() => document.activeElement.id), "waiting");
      for (const name of ["price", "code", "comparison", "class"]) states[name] = "built";
      await isOpen("class");
      assert.deepEqual([await words("waiting"), await ask(() => document.activeElement.id), await ask(() => window.luminaire.class.state.figure)], ["", "class", "cones"]);
      await until(() => window.luminaire.comparison && !window.probe.visible("comparison"));
      await follow("stage");
      await exists("#price-picked b");
      await press("tab-lights");
      await exists("#code-text:not(:empty)");
      // A server that has ended is not asked for ever.
      await ask(() => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File(["{}"], "light.json"));
        document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
      });
      await tells("file-told", "^The file reader is not built yet: 6 of 8");
      end();
      await tells("file-told", "server of the demo does not answer");
      await works();
    } finally {
      end();
    }
  },
  MAY_COMPLAIN,
);

more(
  "what decorates a picture may fail",
  async () => {
    for (const [address, script, id, told] of [
      [STILL, "document.createElementNS = () => { throw new Error('no curve') }", "trouble", "no curve"],
      [
        "#compare?half=10",
        `window.fetch = ((fetch) => (what, ...more) => String(what).endsWith(".json") ? Promise.reject(new TypeError("no list")) : fetch(what, ...more))(window.fetch.bind(window))`,
        "costs-note",
        "no list",
      ],
      [STILL, "Object.defineProperty(window, 'performance', { get: () => undefined })", "failure", ""],
    ]) {
      await open(address, { script });
      await works();
      await until((id, told) => document.getElementById(id).textContent.includes(told), id, told);
    }
    const breaks = "{ const { from } = Float64Array; Float64Array.from = (...all) => { if (window.isBroken) throw new Error('no median'); return from.apply(Float64Array, all); } }";
    await open(STILL, { script: breaks });
    await ask(() => void (window.isBroken = true));
    await change("a beam, without a readout", () => enter("light-beam-number", 15));
    await works();
    assert.match(await words("trouble"), /no median/);
  },
  MAY_COMPLAIN,
);

more(
  "only the module's own end stops the demo",
  async () => {
    await open();
    for (const harmless of ["new Error('a fault')", "'a refusal'", "new RangeError('too far')"]) {
      await ask(`void reportError(${harmless})`);
      await ask(`void Promise.reject(${harmless})`);
      await settle();
      await works();
      assert.ok(await shows("trouble"), `${harmless} is not told`);
    }
    await change("a beam, after faults", () => enter("light-beam-number", 15));
    for (const deadly of [
      "void reportError(new WebAssembly.RuntimeError('unreachable'))",
      "void Promise.reject(new WebAssembly.RuntimeError('unreachable'))",
      "void dispatchEvent(new CustomEvent('luminaire-panic', { detail: 'unreachable' }))",
    ]) {
      await open();
      await ask(deadly);
      await until(() => document.body.dataset.state === "failed");
      assert.match(await words("failure"), /unreachable.*Reload/s);
      assert.ok(await ask(() => document.querySelector("main").inert), `${deadly} leaves dead controls`);
    }
  },
  MAY_COMPLAIN,
);

// The network.

quick(
  "the page's policy forbids all other code and data",
  async () => {
    await open();
    for (const [directive, act] of [
      ["script-src-elem", "document.head.append(Object.assign(document.createElement('script'), { text: '0' }))"],
      ["script-src", "setTimeout('0')"],
      ["script-src-elem", "import('https://example.org/a.js').catch(() => {})"],
      ["style-src-elem", "document.head.append(Object.assign(document.createElement('style'), { textContent: 'a{}' }))"],
      ["img-src", "(new Image()).src = 'data:image/gif;base64,R0lGODlhAQABAAAAACw='"],
      ["connect-src", "fetch('https://example.org/').catch(() => {})"],
    ]) {
      const found = await ask(`new Promise((resolve) => {
        addEventListener("securitypolicyviolation", (event) => resolve(event.effectiveDirective), { once: true });
        ${act};
        setTimeout(resolve, 20000, "nothing");
      })`);
      assert.equal(found, directive, act);
    }
  },
  MAY_COMPLAIN,
);

// The folder for static hosts, which the test run serves under a path, without special headers.

const { hosted } = EXPECT;

quick("the folder for static hosts works under a path", async () => {
  const script = `document.addEventListener("DOMContentLoaded", () =>
    new MutationObserver(() => (window.readyAfter ??= performance.now())).observe(document.body, { attributeFilter: ["data-state"] }))`;
  await open("", { page: hosted.address, plays: true, script });
  await isLit("on a static host");
  assert.ok(!(await ask(() => crossOriginIsolated)), "the server sends special headers");
  // Firefox and WebKit also list the pictures and fonts of their own controls, which are data in the address.
  const names = new Set(requests.filter((address) => !address.startsWith("data:")).map((address) => address.replace(hosted.address, "")));
  const version = hosted.files.find((name) => name.includes("/")).split("/")[0];
  // What the page loads by itself after the first picture, and what a browser without a window does not need.
  const late = /^(curve|handles|press|shapes|icon|sweep|verdict)\./;
  const first = (names) => [...names].map((name) => name.replace(`${version}/`, "")).filter((name) => name && name !== "index.html" && !late.test(name)).sort();
  assert.deepEqual(first(names), first(hosted.files), "the files of the first picture");
  // The page names all of its scripts, so that no script waits for another to arrive. What draws in 32
  // bits comes after the picture.
  await until(() => performance.getEntriesByType("resource").some(({ name }) => name.endsWith("wide_bg.wasm")));
  const files = await ask(() => {
    const early = performance.getEntriesByType("resource").filter(({ startTime }) => startTime < window.readyAfter).map(({ name }) => name);
    const named = Array.from(document.querySelectorAll("link[rel=modulepreload], script[src]"), ({ href, src }) => href ?? src);
    return { wide: early.filter((name) => name.includes("wide")), unnamed: early.filter((name) => name.endsWith(".js") && !named.includes(name)) };
  });
  assert.deepEqual([files.wide, first(files.unnamed.map((name) => name.split("/").at(-1)))], [[], []]);
  for (const view of VIEWS) {
    await open(`?#${view}?play=none`, { page: hosted.address });
    assert.equal(await ask(() => document.querySelector(".views [aria-current]").hash), `#${view}`);
    assert.ok(!(await shows("absent")), `${view} does not open`);
  }
  await open("?#use", { page: hosted.address });
  await until(() => document.getElementById("use-source")?.href === "https://example.org/source/");
  // The picture for link previews has the size that the page states.
  const stated = await ask(() => ["image", "image:width", "image:height", "title", "description", "url"].map((name) => document.querySelector(`meta[property="og:${name}"]`).content));
  assert.ok(stated.every(Boolean), stated.join());
  const [image, width, height] = stated;
  const file = readFileSync(join(hosted.folder, image.replace(hosted.stands, "")));
  assert.deepEqual([file.readUInt32BE(16), file.readUInt32BE(20)].map(String), [width, height], image);
});

if (hosted.isSmall) {
  more("the first picture and the chip are small, and the chip has its licences", async () => {
    const gzip = (files) => files.reduce((sum, file) => sum + gzipSync(readFileSync(file), { level: 9 }).length, 0);
    must(gzip(hosted.files.map((name) => join(hosted.folder, name))), (bytes) => bytes < 420_000, "less than 420,000 bytes by gzip for the first picture");
    const version = hosted.files.find((name) => name.includes("/")).split("/")[0];
    const files = [version, `${version}/chip`].flatMap((folder) =>
      readdirSync(join(hosted.folder, folder), { withFileTypes: true })
        .filter((entry) => entry.isFile() && /^(chip|luminaire_chip|rp2040)/.test(entry.name))
        .map(({ name }) => join(hosted.folder, folder, name)),
    );
    const [licences, ...others] = files.sort((one) => (one.includes("chip-licenses") ? -1 : 1));
    must(gzip(others), (bytes) => bytes > 50_000 && bytes < 150_000, "50,000 to 150,000 bytes by gzip for the chip");
    const text = readFileSync(licences, "utf8");
    for (const name of ["rp2040js 1.4.1", "rp2040-pac", "Uri Shaked", "Raspberry Pi (Trading) Ltd."]) assert.ok(text.includes(name), name);
  });
}
