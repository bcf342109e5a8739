// The views beside the stage: the comparison of kernels, the museum of faulty ones, and the chip.
import {
  EXPECT, VIEWS, ask, assert, drag, enter, focus, go, more, must, number, open, pause, place, press, quick, redraw,
  requests, shows, tab, until, words,
} from "./visit.mjs";

/** The comparison of the two forms in f32. */
const FORMS = "#compare?left=f32-cosine&right=f32&half=10";

const side = (number) => ask((number) => window.luminaire.comparison.sides[number], number);
const largest = async (number) => (await side(number)).largest;
const sides = () => ask(() => JSON.stringify(window.luminaire.comparison.sides));

quick("a narrow beam parts the cosine form from the versine form", async () => {
  await open(FORMS);
  assert.deepEqual([await shows("comparison"), await shows("view")], [true, false]);
  for (const number of [0, 1]) {
    const codes = await ask((number) => {
      const canvas = document.getElementById(`picture-${number}`);
      return [canvas.width / 2, 0].map((at) => canvas.getContext("2d").getImageData(at, at, 1, 1).data[0]);
    }, number);
    assert.deepEqual(codes, [255, 0], `middle and corner of picture ${number}`);
    must(await largest(number), (error) => error < 1, `form ${number} to be right in a wide beam`);
  }
  await redraw("the slider", () => enter("half-angle", Math.log10(0.05)));
  must(await number("half-angle-number"), (angle) => Math.abs(angle - 0.05) < 1e-6, "0.05 degrees");
  const errors = [await largest(0), await largest(1)];
  must(errors, ([cosine, versine]) => cosine > 20 && versine < 1, "the cosine form to be off by over 20 codes, and the other by less than 1");
  for (const number of [0, 1]) {
    must(Number(await words(`largest-${number}`)), (told) => Math.abs(told - errors[number]) <= 0.1 * errors[number], `${errors[number]} codes`);
    assert.match(await words(`differing-${number}`), /%$/);
  }
  const told = (await words("verdict")).match(/^A: .* by at most (\d+) of 255\. B: (.*)$/);
  const isRight = () => Number(told?.[1]) > 20 && /64-bit floats(, by at most 1 of 255)?/.test(told?.[2]);
  must(told, isRight, "one sentence: the cosine far off, and the versine right");
});

more("the divider follows the mouse and the keys", async () => {
  await open(FORMS);
  const split = async () => {
    const at = await number("divider");
    assert.equal(at, await number("errors-divider"), "the place of the two dividers");
    const clip = await ask(() => getComputedStyle(document.querySelector("#comparison .half")).clipPath);
    const cut = clip.replaceAll("calc(", "");
    must(cut, () => at === 0 || cut.includes(String(100 - at).slice(0, 4)), `a picture that is cut at ${at} %`);
    return at;
  };
  const start = await split();
  await drag(await place("#divider"), [90, 0]);
  const dragged = await split();
  must(dragged, () => dragged > start + 5, `a place right of ${start}`);
  await focus("divider");
  await tab.keyboard.press("ArrowLeft");
  must(await split(), (pressed) => pressed < dragged, `a place left of ${dragged}`);
  await tab.keyboard.press("Home");
  assert.equal(await split(), 0);
});

more("a refused cone has a message, with a remedy", async () => {
  await open(FORMS);
  const refusal = () => words("refusal-1");
  await enter("form-1", "fx16");
  assert.equal(await refusal(), "");
  await enter("half-angle-number", 0.1);
  assert.match(await refusal(), /Fx16.*expected a half angle of at least 0\.6/);
  assert.deepEqual([await shows("refusal-1"), await shows("widen-1"), await words("refusal-0"), await words("largest-1")], [true, true, "", "refused"]);
  await redraw("the remedy", () => press("widen-1"));
  assert.equal(await refusal(), "");
  must(await number("half-angle-number"), (angle) => angle > 0.65 && angle < 0.75, "a remedy of about 0.7 degrees");
  must(await largest(1), (error) => error < 1, "an error of less than a code");
});

more("bad values leave the comparison alone", async () => {
  await open(FORMS);
  const before = await sides();
  await enter("half-angle-number", "1e40");
  assert.match(await words("half-angle-error"), /half angle.*expected 0\.002 to 60 degrees/);
  assert.equal(await sides(), before);
  await enter("half-angle-number", 10);
  assert.equal(await words("half-angle-error"), "", "10 degrees");
  await open("#compare?left=f16&right=&half=wide");
  assert.match(await words("refusal-0"), /form = "f16"/);
  assert.match(await words("refusal-1"), /form = ""/);
  assert.match(await words("half-angle-error"), /is no number: expected/);
  must(await largest(0), (error) => error >= 0, "a picture");
});

more("the scale of the errors is chosen", async () => {
  await open("#compare?left=f32-cosine&right=f32&half=0.1");
  const colours = () => ask(() => document.getElementById("errors-0").toDataURL());
  const automatic = await colours();
  assert.match(await words("tick-end"), /^50 codes/, "errors of 46 codes");
  await redraw("the scale", () => enter("scale", 255));
  assert.match(await words("tick-end"), /^255 codes/);
  assert.notEqual(await colours(), automatic, "the scale leaves the colours as they were");
  await redraw("the automatic scale", () => enter("scale", ""));
  assert.equal(await colours(), automatic);
});

more("the pictures of the comparison are timed", async () => {
  await open(FORMS);
  await ask(async () => void (await window.luminaire.comparison.measured));
  for (const number of [0, 1]) must((await words(`time-${number}`)).match(/^([\d.]+) ms$/), (time) => Number(time?.[1]) > 0, "a time");
});

/** Rows of a price list: kernel, stage, format, error in codes, its kind, and the costs. */
const ROWS = [
  ["lit", "lit", "f32", { codes: 0.25, kind: "searched" }, { "cortex-m0": { instructions: 5000 }, host: { ns: 2.5 } }],
  ["lit", "lit", "f32-cosine", { codes: 0.5, kind: "searched" }, { "cortex-m0": { instructions: 2500 }, host: { ns: 5 } }],
  ["soft", "falloff", "f32", { codes: 1e-5, kind: "exhaustive" }, { "cortex-m0": { instructions: 428 } }],
  ["powf-libm", "falloff", "rival", null, { "cortex-m0": { instructions: 9905 } }],
];

/** A script that answers the page's request for the price list. */
const answering = (list) => `{ const ask = window.fetch.bind(window);
  window.fetch = (what, ...more) => String(what).endsWith("prices.json")
    ? Promise.resolve(new Response(${JSON.stringify(JSON.stringify(list))})) : ask(what, ...more); }`;

more("prices stand beside the errors", async () => {
  const record = { errors: { figures: {} } };
  for (const [kernel, stage, format, error, cost] of ROWS) {
    const name = `${kernel}.${format}`;
    record.errors.figures[name] = { stage, ...error };
    for (const [target, figures] of Object.entries(cost)) ((record[target] ??= { figures: {} }).figures[name] = figures);
  }
  await open(FORMS, { script: answering(record) });
  const cells = (selector) => ask((selector) => Array.from(document.querySelectorAll(selector), (row) => row.innerText).join("|"), selector);
  must(await cells("#costs tr"), (costs) => costs.includes("Cortex-M0\t2,500\t5,000") && costs.includes("5 ns\t2.5 ns"), "both costs");
  await enter("half-angle-number", 0.1);
  assert.match(await words("verdict"), /for 2 times the instructions of A\.$/);
  // The list has no lit point for the power, so both forms are compared by their falloff alone.
  await enter("form-0", "powf");
  must(await cells("#costs tr"), (costs) => costs.includes("Cortex-M0\t9,905\t428"), "the costs of the falloffs");
  // The curve differs, too, so that the errors cannot be compared.
  must(await words("verdict"), (told) => told.includes("different curves") && !told.includes("64-bit"), "a verdict without errors");
  await open(FORMS, { script: answering(null) });
  assert.match(await words("costs-note"), /cargo xtask measure/);
});

// The museum.

const exhibit = () => ask(() => window.luminaire.museum.state);

/** Fails unless the errors of an exhibit are those of the host, at one of its values. */
async function agrees({ name, at }, value) {
  const state = await exhibit();
  const expected = at.find((errors) => errors.value === value);
  assert.equal(state.exhibit, name);
  must(state.value, (found) => Math.abs(found - value) <= 1e-6 * Math.abs(value), `${name}: ${value}`);
  state.sides.forEach(({ largest, undefined: none }, i) => {
    const { largest: error, undefined: count } = expected.sides[i];
    must([largest, none], () => Math.abs(largest - error) <= 1e-6 * error && none === count, `${name} at ${value}, side ${i}: ${error}, and ${count} undefined`);
  });
}

quick("every exhibit of the museum shows the errors that the host computes", async () => {
  await open("#museum?exhibit=beam-or-field");
  assert.deepEqual([await shows("museum"), await shows("view")], [true, false]);
  assert.deepEqual(await ask(() => window.luminaire.museum.names), EXPECT.museum.map(({ name }) => name));
  for (const one of EXPECT.museum) {
    await redraw(one.name, () => press(`exhibit-of-${one.name}`));
    assert.equal(await words("exhibit-title"), one.title);
    await agrees(one, one.start);
    await until(() => location.hash.startsWith("#museum?exhibit=") && location.hash.includes("at="));
  }
  // Small pictures are drawn one after the other.
  await until(() => [...document.querySelectorAll(".exhibits canvas")].every((canvas) => canvas.width === 48));
});

more("the control of the museum changes the errors", async () => {
  const [first, second] = EXPECT.museum;
  await open(`#museum?exhibit=${first.name}&at=0.5`);
  await agrees(first, 0.5);
  const narrow = await words("exhibit-largest-0");
  await redraw("the slider", () => enter("exhibit-value", Math.log10(1.9)));
  await redraw("the number", () => enter("exhibit-number", 2));
  await agrees(first, 2);
  assert.notEqual(await words("exhibit-largest-0"), narrow, "half a degree and two degrees");
  await redraw("the button", () => press("exhibit-agrees"));
  await agrees(first, first.agreesAt);
  await focus(`exhibit-of-${first.name}`);
  await redraw("an arrow key", () => tab.keyboard.press("ArrowDown"));
  assert.equal((await exhibit()).exhibit, second.name);
});

more("bad values leave the museum alone", async () => {
  await open("#museum?exhibit=none&at=1e9");
  assert.match(await words("exhibit-error"), /expected 0\.1 to 20/);
  const before = await exhibit();
  for (const value of ["0", "-1", "21", "1e40"]) {
    await enter("exhibit-number", value);
    assert.match(await words("exhibit-error"), /Half angle/, value);
    assert.deepEqual(await exhibit(), before, value);
  }
  await open("#museum?exhibit=none");
  assert.match(await words("exhibit-error"), /exhibit = "none"/);
});

more("pictures of the museum have their own size", async () => {
  await open("#museum");
  const scales = await ask(() => Array.from(document.querySelectorAll(".sides canvas"), (canvas) => canvas.getBoundingClientRect().width / canvas.width));
  assert.deepEqual(scales, [1, 1, 1, 1]);
});

quick("threads of the museum are links to their host", async () => {
  await open("#museum?exhibit=pow-zero");
  const links = await ask(() => Array.from(document.querySelectorAll("#exhibit-thread a"), ({ href, textContent }) => [textContent, href]));
  must(links, (links) => links.length > 1 && links.every(([text, href]) => href.endsWith(`/issues/${text.split("#")[1]}`)), "links");
  must(links[1], ([, href]) => href.includes("/godotengine/godot/"), "the repository of the number before");
});

quick("the view of the use has the program of the selected light, and files", async () => {
  const [{ scene, light, texts }] = EXPECT.code.lights;
  const script = "window.blobs = {}; { const make = URL.createObjectURL; URL.createObjectURL = (blob) => { const url = make.call(URL, blob); window.blobs[url] = blob; return url; }; }";
  await open(`#stage?play=none&scene=${scene}`, { script });
  await press(`light-${light}`);
  await go("use");
  assert.equal(await ask(() => document.getElementById("use-code").textContent), texts["rust-program"]);
  for (const [id, name] of [["script", "rust-build"], ["header", "luminaire.h"], ["constants", "luminaire_constant.h"], ["constant", "c-fx16"]]) {
    const text = await ask(async (id) => window.blobs[document.getElementById(`use-${id}`).href].text(), id);
    assert.equal(text, texts[name] ?? EXPECT.code.headers[name], name);
  }
  assert.ok(!(await shows("use-links")), "links to no repository");
});

// The chip.

/** Waits until a stopped chip sends no more pictures. Returns how many it has shown. */
async function rests() {
  for (let before; ; await pause(500)) {
    const drawn = await ask(() => window.luminaire.chip.drawn);
    if (drawn === before) return drawn;
    before = drawn;
  }
}

if (VIEWS.includes("chip")) {
  more("the chip in the page shows the right pixels, and is loaded when opened", async () => {
    await open();
    const isOfTheChip = (address) => /^(chip|luminaire_chip|rp2040)/.test(address.split("/").at(-1));
    assert.deepEqual(requests.filter(isOfTheChip), [], "files that are loaded before the view is opened");
    await ask(() => void (location.hash = "#chip"));
    await until(() => window.luminaire.chip?.drawn >= 3);
    await press("chip-run");
    const before = await rests();
    const picture = await ask(() => window.luminaire.chip.picture);
    assert.deepEqual([picture.differing, picture.count, await words("chip-differ")], [0, 19_200, "0"]);
    assert.match(picture.name, /^frame /);
    assert.equal(await words("chip-name"), picture.name);
    assert.deepEqual([await words("chip-checksum"), await words("chip-expected")], [picture.checksum, picture.checksum]);
    must(Number(await words("chip-cycles")), (cycles) => cycles >= 100 && cycles < 1000, "100 to 1000 cycles a pixel");
    assert.equal((await ask(() => window.probe.place("#chip-display").width)) % 240, 0, "the pixels have unequal sizes");
    // Stopped, the chip shows one picture more when the visitor steps.
    await press("chip-picture");
    await until((before) => window.luminaire.chip.drawn > before, before);
    assert.equal(await rests(), before + 1, "a step shows another number of pictures");
  });
}
