// A light on the desk and in the picture: its angles, its values and what refuses them, its place, its code and its price.
import {
  EXPECT, STILL, ask, assert, change, count, drag, enter, exists, focus, hash, isDisabled, isShown, isWritten, more, must, number, open, openPrice, options,
  place, press, quick, requests, settle, shows, sum, tab, type, until, value, words, written,
} from "./visit.mjs";

/** A scene of one light, paused, with the lights in the picture. */
const ONE = "#stage?scene=bare-spot&play=none";
const SMALL = `?workers=0&rest=0&width=64&height=36`;

const angles = async () => [await number("light-beam-number"), await number("light-field-number")];

const near = (found, expected, most = 1e-3) =>
  found.forEach((found, i) => must(found, (found) => Math.abs(found / expected[i] - 1) < most, `about ${expected[i]}`));

/** A slider beyond the other one must move that, however the angles are coupled. */
for (const [mine, other, end, register] of [["field", "beam", "min", quick], ["beam", "field", "max", more]]) {
  register(`the ${mine} slider changes the picture and leads the ${other} angle`, async () => {
    await open();
    const least = await ask((id, end) => Number(window.probe.element(id)[end]), `light-${mine}`, end);
    const before = await number(`light-${other}`);
    await change("the slider", () => enter(`light-${mine}`, (least + before) / 2));
    const [moved, follower] = [await number(`light-${mine}`), await number(`light-${other}`)];
    const side = mine === "field" ? 1 : -1;
    must([moved, follower, before], () => side * (before - moved) > 0 && side * (moved - follower) >= 0, `the ${other} angle to follow`);
    must(Math.log10(await number(`light-${mine}-number`)), (log) => Math.abs(log - moved) < 0.01, `the number of ${moved}`);
  });
}

quick("12 and 22 degrees are typed in both orders, with every edge", async () => {
  await open(`${SMALL}${ONE}`);
  const numbers = { beam: 12, field: 22 };
  const usual = await options("light-edge");
  await enter("light-edge", "more");
  assert.deepEqual([usual.length, usual.at(-1), await value("light-edge")], [8, "more", "own"], "the edges that are offered at once");
  must(await options("light-edge"), (all) => all.length === usual.length + 8 && !all.includes("more"), "all edges after more");
  for (const edge of await options("light-edge")) {
    for (const order of [["beam", "field"], ["field", "beam"]]) {
      await press("reset");
      await enter("light-edge", edge);
      for (const name of order) await type(`light-${name}-number`, String(numbers[name]));
      near(await angles(), [12, 22]);
      assert.equal(await words("light-error"), "", edge);
    }
  }
  // What is typed is one step, and a refusal is read before it goes.
  await written();
  await type("light-field-number", "15");
  await written();
  await press("undo");
  near(await angles(), [12, 22]);
  await type("light-field-number", "400");
  assert.match(await words("light-error"), /^field angle = 400: expected [\d.]+ to [\d.]+ degrees in 16-bit fixed point$/);
  near(await angles(), [12, 22]);
});

quick("a pair of angles that no edge has is drawn as the nearest, which is said", async () => {
  await open(`${SMALL}${ONE}`);
  await type("light-field-number", "40");
  await type("light-beam-number", "10");
  near(await angles(), [10, 40]);
  assert.deepEqual([await value("light-edge"), await words("light-error")], ["fitted-soft", ""], "a soft edge has both");
  await type("light-field-number", "22");
  await type("light-beam-number", "40");
  near(await angles(), [40, 40]);
  assert.match(await words("light-error"), /^field angle = 22: expected 40 to [\d.]+ degrees beside a beam angle of 40\. Drawn is the nearest pair, 40° and 40°\.$/);
  const isUnder = () => document.getElementById("light-error").previousElementSibling.contains(document.getElementById("light-beam-number"));
  assert.ok(await ask(isUnder), "it is said elsewhere");
  await type("light-beam-number", "20");
  assert.equal(await words("light-error"), "");
});

quick("a refusal names the control that was used, in its unit", async () => {
  await open(`${SMALL}${ONE}`);
  for (const [id, text, told] of [
    ["light-beam-number", "0.000000001", /^beam angle = 1e-9: expected [\d.]+ to [\d.]+ degrees in 16-bit fixed point$/],
    ["light-field-number", "170", /^field angle = 170: expected [\d.]+ to [\d.]+ degrees/],
    ["light-aim-y", "1e39", /^aim y = inf: expected -\d+ to \d+ metres$/],
    ["light-z", "-99999", /^position z = -99999: expected -\d+ to \d+ metres$/],
    ["light-beam-number", "12e", /^beam angle is no number: expected/],
    ["light-x", "-", /^position x is no number: expected/],
  ]) {
    await type(id, text);
    assert.match(await words("light-error"), told, text);
  }
});

quick("a drag and a slider end where they began", async () => {
  await open(`${SMALL}#stage?scene=bare-spot&play=none&format=f32&lights=0:b12:f22`);
  await exists("#curve .handle");
  const flux = () => number("light-intensity-number");
  const before = await flux();
  // The dot of the beam angle: to the axis and back, in one drag.
  const [x, y] = await place("#curve .handle circle:nth-child(2)");
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  for (const share of [0.2, 0.4, 0.95, 0.5, 0]) {
    const across = await ask(() => (({ left, width }) => left + width * (240 / 440))(document.getElementById("curve").getBoundingClientRect()));
    await tab.mouse.move(x + share * (across - x), y, { steps: 2 });
  }
  await tab.mouse.up();
  const [beam, field] = await angles();
  must([beam, field], () => Math.abs(beam - 12) < 0.1 && Math.abs(field - 22) < 0.01, "12 and 22 degrees");
  // The slider of the beam angle: to its end and back.
  await type("light-beam-number", "12");
  near(await angles(), [12, 22]);
  await focus("light-beam");
  await tab.keyboard.press("Home");
  must(await angles(), ([, field]) => field < 1, "the field angle to follow");
  await ask(() => {
    const slider = document.getElementById("light-beam");
    slider.value = String(Math.log10(12));
    slider.dispatchEvent(new Event("input"));
  });
  near(await angles(), [12, 22]);
  near([await flux()], [before]);
});

quick("a colour temperature is the light's colour until another is chosen", async () => {
  await open(ONE);
  const state = async () => [await value("light-color"), await value("light-kelvin-number"), await number("light-intensity-number")];
  const before = await state();
  assert.equal(before[1], "");
  await change("warm light", () => enter("light-kelvin-number", 3000));
  assert.deepEqual(await state(), ["#ffb86d", "3000", before[2]]);
  const [address, warm] = [await isWritten(/lights=0:w3000/), await sum()];
  await open(address);
  assert.equal(await sum(), warm);
  await change("another colour", () => enter("light-color", "#40ff80"));
  assert.deepEqual(await state(), ["#40ff80", "", before[2]]);
});

more("beam and field angle are set on the curve, and another edge keeps the field angle", async () => {
  await open();
  const [beam, field] = await angles();
  const dot = "#curve [role=slider]";
  await exists(dot);
  await drag(await place(`${dot} .dot`), [2, 0]);
  await settle();
  assert.equal((await angles())[0], beam, "a click on the dot sets the angle");
  await ask((dot) => document.querySelector(dot).focus(), dot);
  await change("a key", () => tab.keyboard.press("ArrowLeft"));
  const [narrower] = await angles();
  near([narrower / beam], [0.99], 0.002);
  assert.deepEqual([(await angles())[1], await value("light-edge")], [field, "fitted"]);
  await enter("light-field-number", 35);
  assert.deepEqual(await angles(), [narrower, 35], "a data sheet's two angles");
  await change("a soft edge", () => enter("light-edge", "fitted-soft"));
  assert.deepEqual(await angles(), [narrower, 35], "the angles of a soft edge");
  const [soft, drawn] = [await isWritten(/:esoft:/), await sum()];
  await change("another edge", () => enter("light-edge", "smooth"));
  assert.equal((await angles())[1], 35, "the field angle with another edge");
  await open(soft);
  assert.deepEqual([await value("light-edge"), await sum()], ["fitted-soft", drawn], "of a link");
});

/** A field that is cleared is about to be filled. A field that is left shows the value in force. */
async function forgives(id, error) {
  const told = async () => [await words(error), await ask((id) => document.getElementById(id).getAttribute("aria-invalid") === "true", id)];
  const leave = async () => (await ask((id) => document.getElementById(id).blur(), id), settle());
  const good = await value(id);
  const isGood = async (what) => assert.deepEqual([...(await told()), await value(id)], ["", false, good], `${id}, ${what}`);
  await enter(id, "");
  assert.deepEqual(await told(), ["", false], `${id}, cleared`);
  await leave();
  await isGood("left empty");
  await enter(id, "-3");
  must(await told(), ([words, isInvalid]) => words && isInvalid, `-3 to be refused for ${id}`);
  await enter(id, "");
  assert.deepEqual(await told(), ["", false], `${id}, cleared of -3`);
  await enter(id, "-3e38");
  must(await told(), ([words]) => words.includes("= -3e38: "), `-3e38 to be refused for ${id}`);
  await leave();
  await isGood("left with -3e38");
  // The browser distinguishes a text that is no number from an empty field.
  await ask((id) => (document.getElementById(id).focus(), document.getElementById(id).select()), id);
  await tab.keyboard.type("e");
  await tab.keyboard.press("Enter");
  // A refusal that nobody can have read yet stays when the field is left.
  await settle();
  must(await told(), ([words]) => words.includes(" is no number: "), `e to be refused for ${id}`);
  await leave();
  await isGood("left with e");
}

more("an empty field is no error, and a field that is left shows what is in force", async () => {
  await open();
  await enter("light-fixture", "ARRI L7-C");
  await enter("light-kelvin-number", 3000);
  for (const name of ["beam", "field", "zoom", "intensity", "kelvin"]) await forgives(`light-${name}-number`, "light-error");
  await open("#compare?half=10");
  await forgives("half-angle-number", "half-angle-error");
});

more("what a format refuses is stated under no other control", async () => {
  await open();
  await enter("format", "f32");
  await enter("light-beam-number", "1");
  await enter("format", "fx16");
  assert.match(await words("stage-error"), /16-bit fixed point cannot hold light 1/);
  assert.ok(await shows("stage-error"), "the refusal is not seen");
  assert.deepEqual([await words("light-error"), await value("format")], ["", "f32"]);
  await enter("light-beam-number", "30");
  assert.equal(await words("stage-error"), "");
  await enter("format", "fx16");
  await enter("light-beam-number", "1");
  assert.match(await words("light-error"), /^beam angle = 1: expected .* in 16-bit fixed point$/);
  const isUnder = () => document.getElementById("light-error").previousElementSibling.contains(document.getElementById("light-beam-number"));
  assert.ok(await ask(isUnder), "the refusal stands elsewhere");
});

/** The middle of a handle, which the page loads late. */
async function handle(id) {
  await isShown(id);
  return place(`#${id}`);
}

quick("a light is aimed by mouse, as one step", async () => {
  await open(ONE);
  const aim = await handle("handle-aim");
  await change("a drag of the pool", () => drag(aim, [60, 10]));
  const after = await place("#handle-aim");
  must(after, ([x, y]) => Math.abs(x - aim[0] - 60) + Math.abs(y - aim[1] - 10) < 4, `the pool 60, 10 from ${aim}`);
  await isWritten(/:t/);
  await change("undo", () => press("undo"));
  must(await place("#handle-aim"), ([x]) => Math.abs(x - aim[0]) < 1, `one undo to lead to ${aim}`);
  assert.ok(await isDisabled("undo"), "a drag takes more than one undo");
});

quick("press, wheel and drag do what the hint says, on every target in the picture", async () => {
  await open("#stage?scene=three-point&play=none&with=f32");
  await isShown("handle-aim");
  const targets = ["#view", "#handles .area", "#handle-aim", "#handle-0", "#divided .divider"];
  /** A place at which a target is on top, in the window; none if it is covered or beside the picture. */
  const top = (selector) =>
    ask((selector) => {
      const target = document.querySelector(selector);
      const { left, top, width, height } = document.getElementById("frame").getBoundingClientRect();
      for (let i = 0; i < 60 * 34; i += 1) {
        const place = [left + (width * ((i % 60) + 0.5)) / 60, top + (height * (Math.floor(i / 60) + 0.5)) / 34];
        const found = document.elementFromPoint(...place);
        if (found && (found === target || (target.localName === "g" && target.contains(found)))) return place;
      }
      return undefined;
    }, selector);
  const acts = new Map();
  for (const target of targets) {
    await press("reset");
    await ask(() => (document.activeElement.blur(), scrollTo(0, 0)));
    await settle();
    const at = await top(target);
    if (!at) continue;
    await tab.mouse.move(...at);
    await tab.mouse.down();
    await tab.mouse.up();
    assert.ok(await ask(() => document.getElementById("frame").contains(document.activeElement)), `${target}: a press takes no focus`);
    const state = async () => (await written(), (await hash()).match(/view=[^&]*|lights=[^&]*/g)?.join() ?? "");
    const opened = await state();
    await tab.mouse.wheel({ deltaY: 100 });
    await until((opened) => (location.hash.match(/view=[^&]*|lights=[^&]*/g)?.join() ?? "") !== opened, opened);
    assert.equal(await ask(() => scrollY), 0, `${target}: the wheel scrolls the page`);
    const zoomed = await state();
    await drag(at, [40, 12]);
    const dragged = await state();
    acts.set(target, [zoomed.split("=")[0], dragged !== zoomed]);
  }
  assert.deepEqual(Object.fromEntries(acts), {
    "#view": ["view", true],
    "#handles .area": ["lights", true],
    "#handle-aim": ["lights", true],
    "#handle-0": ["view", true],
    "#divided .divider": ["view", false],
  });
});

quick("a light is selected in the picture and moved by keys", async () => {
  await open("#stage?scene=show&play=none");
  const third = await handle("handle-3");
  await drag(third, [1, 1]);
  await settle();
  assert.equal(await words("panel-title"), "4 moving head (beam)");
  must(await place("#handle-3"), ([x, y]) => Math.abs(x - third[0]) + Math.abs(y - third[1]) < 1, `a light at ${third} after a click`);
  const x = await number("light-x");
  assert.equal(await ask(() => document.activeElement.id), "handle-3");
  await change("an arrow key", () => tab.keyboard.press("ArrowRight"));
  must(await number("light-x"), (found) => found > x + 0.05, `a light right of ${x}`);
  assert.match(await words("light-way"), /^The scene moves the aim/);
  await change("an aim", () => enter("light-aim-y", 0.5));
  assert.equal(await words("light-way"), "Moved by you.");
  await change("the way back", () => press("light-back"));
  assert.equal(await number("light-x"), x);
  await press("handles-shown");
  assert.ok(!(await shows("handle-3")), "the switch leaves the lights in the picture");
  await isWritten(/&handles=0$/);
});

more("lights are copied and removed", async () => {
  await open();
  await press("light-1");
  assert.equal(await words("panel-title"), "2 Fresnel (fill)");
  await change("a copy", () => press("light-copy"));
  assert.equal(await words("lights-count"), "4 of 4 on");
  await change("the copy", () => enter("light-color", "#ff0000"));
  await change("removal", () => press("light-remove"));
  for (let light = 0; light < 3; light += 1) {
    await press("light-remove");
    await settle();
  }
  assert.equal(await words("lights-count"), "0 of 0 on");
  assert.ok(!(await shows("panel")), "the panel of no light is shown");
  assert.equal(await ask(() => document.activeElement.id), "light-add", "the focus after the last light");
  await change("a light in the dark", () => press("light-add"));
  await change("reset", () => press("reset"));
});

quick("the law of distance, the kind of a light and the highlights are set and undone", async () => {
  await open(`${SMALL}#stage?scene=three-point&play=none`);
  await change("a law", () => enter("light-law", "unattenuated"));
  await enter("light-law", "polynomial");
  await change("a number of the law", () => enter("light-law-1", 2));
  await type("light-law-2-number", "-3");
  assert.match(await words("light-error"), /^attenuation coefficient = -3: expected a finite number from 0 to 1000000000/);
  await isWritten(/lights=0:apolynomial\/1\/2\/0.03_/);
  await change("a point light", () => enter("light-kind", "point"));
  assert.ok(await shows("light-law-numbers") && !(await shows("light-cone")), "a point light has a law and no cone");
  await isWritten(/lights=0:kpoint:apolynomial\/1\/2\/0.03_/);
  await change("a directional light", () => enter("light-kind", "directional"));
  assert.ok((await isDisabled("light-law")) && !(await shows("light-law-numbers")), "a law without a distance");
  await isWritten(/lights=0:kdirectional:apolynomial\/1\/2\/0.03_/);
  await press("undo");
  assert.equal(await value("light-kind"), "point");
  await change("highlights", () => enter("highlight", "0.5"));
  await change("their exponent", () => enter("shininess", "1024"));
  await isWritten(/&highlight=0.5&shininess=1024$/);
});

quick("an edge has a dial for each of its numbers", async () => {
  await open(`${SMALL}#stage?scene=three-point&play=none`);
  assert.ok(!(await shows("light-edge-numbers")), "the light's own edge has dials");
  await enter("light-edge", "more");
  await change("an edge with a number", () => enter("light-edge", "power"));
  await change("its exponent", () => enter("light-edge-0", Math.log10(20)));
  await isWritten(/lights=0:epower\/20[:_]/);
  await type("light-edge-0-number", "2.5");
  assert.match(await words("light-error"), /^exponent = 2.5: expected a whole number from 1 to/);
  await enter("light-edge", "cubic");
  assert.equal(await words("light-error"), "", "a refusal ends with its dial");
  assert.equal(await count("#light-edge-numbers .dial"), 2, "the dials of a cubic");
  await enter("light-edge", "soft");
  assert.ok(!(await shows("light-edge-numbers")), "a soft edge has no number");
});

// The drawer with the code of the selected light.

const code = () => ask(() => document.getElementById("code-text").textContent);

/** Opens the page and then the drawer, and waits for the code. */
async function openCode(address = STILL, script) {
  await open(address, { script });
  const early = requests.filter((name) => name.includes("code") && !name.includes("code-slot"));
  assert.deepEqual(early, [], "files that are loaded before the drawer is opened");
  await ask(() => document.querySelector("#code summary").click());
  await until(() => document.getElementById("code-text").textContent);
}

quick("the code of a light follows its settings", async () => {
  await openCode();
  await enter("code-language", "glsl");
  const before = await code();
  await change("the slider", () => enter("light-field", 0.3));
  const after = await code();
  const field = (await number("light-field-number")).toFixed(2);
  must(after, () => after !== before && after.includes(`field ${field}`), `the code of a field angle of ${field}`);
  await change("undo", () => press("undo"));
  assert.equal(await code(), before);
  await press("light-1");
  const other = await code();
  assert.match(other, /vec3 light_2_color/);
  // Neither the switch of a light nor the exposure is a part of it.
  await change("the switch", () => press("light-1-on"));
  await change("the exposure", () => enter("exposure", 1));
  assert.equal(await code(), other);
});

more("the code of a light is what the exporter writes, in every language", async () => {
  const { lights, headers } = EXPECT.code;
  for (const { scene, light, texts } of lights) {
    await openCode(`#stage?play=none&scene=${scene}`);
    await press(`light-${light}`);
    assert.deepEqual(new Set(await options("code-language")), new Set(Object.keys({ ...texts, ...headers })));
    for (const [language, text] of Object.entries({ ...texts, ...headers })) {
      await enter("code-language", language);
      assert.equal(await code(), text, `${scene}, light ${light}, ${language}`);
    }
  }
});

more("the code of a light is copied, or selected", async () => {
  for (const [act, took, told] of [
    ["window.copied = text;", () => window.copied, /Copied\./],
    ["throw new DOMException('no', 'NotAllowedError');", () => getSelection().toString(), /Ctrl\+C/],
  ]) {
    await openCode(STILL, `Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => { ${act} } } })`);
    await focus("code-copy");
    await press("code-copy");
    await until(() => document.getElementById("code-told").textContent);
    assert.match(await words("code-told"), told);
    assert.equal((await ask(took)).trim(), (await code()).trim());
  }
});

more("the code of a light that a language cannot hold is refused in words", async () => {
  await openCode("#stage?play=none&scene=gallery");
  await press(`light-${EXPECT.code.sun}`);
  const seen = async () => [await shows("code-error"), await shows("code-text"), await shows("code-copy")];
  await enter("code-language", "c-fx16");
  assert.match(await words("code-error"), /a spotlight or a point light/);
  assert.deepEqual(await seen(), [true, false, false]);
  await enter("code-language", "glsl");
  assert.deepEqual([await words("code-error"), await shows("code-text")], ["", true], "the GLSL of a sun");
});

quick("the price of a light follows the format and the tolerance", async () => {
  await open();
  assert.deepEqual(requests.filter((name) => name.includes("price-panel")), [], "files that are loaded before the price is in view");
  await openPrice();
  const seen = [];
  for (const [format, name] of [["fx16", "16 bits"], ["fx32", "32 bits"], ["f32", "f32"]]) {
    await ask((format) => window.luminaire.setFormat(format), format);
    const point = (name) =>
      document.getElementById("price-format")?.textContent === name && document.querySelector("#price-chart .point.current")?.getAttribute("cx");
    const place = await until(point, name);
    const chips = await ask(() => [...document.querySelectorAll("#price-chips tr")].map((row) => row.textContent).join());
    for (const chip of ["Cortex-M0+", "Cortex-M3", "Cortex-M4F", "RV32IMC", "Cortex-M7", "Cortex-M33", "Hazard3"]) assert.ok(chips.includes(chip), chips);
    assert.equal(chips.split(" ms").length - 1, 7, chips);
    seen.push([place, chips]);
  }
  for (const part of [0, 1]) assert.equal(new Set(seen.map((price) => price[part])).size, 3, `two formats have the same price: ${seen}`);
  assert.match(await words("price-live"), / ns of a core for a lit point/);
  // A stricter tolerance has another answer.
  const answers = [];
  for (const most of [5, 0.01]) {
    await ask((most) => {
      const field = document.getElementById("price-most");
      field.value = String(most);
      field.dispatchEvent(new Event("input"));
    }, most);
    await until((most) => document.querySelector("#price-chart .allowed") !== null && window.luminaire.price.tolerance === most, most);
    answers.push(await words("price-picked"));
  }
  must(answers, ([rough, strict]) => /error found .*, bound /.test(rough) && rough !== strict, "two answers");
  // A dot of the chart is a choice.
  await ask(() => document.querySelector("#price-chart [aria-label='Draw the picture in 32 bits']").dispatchEvent(new MouseEvent("click")));
  assert.equal(await value("format"), "fx32");
});
