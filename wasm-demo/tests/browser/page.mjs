// The page fits every window, gestures end where they began, and nothing is refused that a control offers.
import {
  STATES, VIEWS, ask, assert, exists, focus, go, hash, isDisabled, isShown, long, must, open, place, press, quick, resize, scenes,
  settle, show, tab, until, written,
} from "./visit.mjs";

/** Windows from a telephone, or a laptop at 400 %, to a large display, in pixels. */
const WIDTHS = [
  320, 360, 390, 412, 480, 600, 640, 700, 768, 820, 900, 1023, 1024, 1100, 1280, 1366, 1440, 1536, 1920, 2560, 3840,
];

/** A small picture, which the page draws itself. */
const SMALL = "?workers=0&rest=0&width=64&height=36";

quick("no name is over another and nothing scrolls sideways, from 320 to 3,840 pixels", async () => {
  await open(`${SMALL}#stage?scene=bare-spot&play=none`);
  const states = (await scenes()).map((scene) => `stage?play=none&scene=${scene}`);
  for (const hash of [...states, "stage?play=none&scene=show&with=fx16&lights=0:i2073500", ...VIEWS.filter((view) => view !== "stage")]) {
    await go(hash);
    for (const width of WIDTHS) {
      await resize(width, 900);
      await until((width) => innerWidth === width, width);
      const faults = await ask(() => {
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

long("no text is cut or covered, on four screens and at 200 %", async () => {
  for (const state of STATES) {
    await show(state);
    // The last is a window of 1280 x 900 pixels at 200 %.
    for (const [width, height, density] of [[390, 844, 1], [768, 1024, 1], [1280, 900, 1], [640, 450, 2]]) {
      await resize(width, height, density);
      await settle();
      assert.deepEqual(await ask(() => window.probe.misplaced()), [], `${state.name}, ${width} pixels wide`);
    }
  }
});

quick("the picture is in view beside every part of the desk, and Verify in the first screen", async () => {
  await open(`${SMALL}#stage?scene=show&play=none`);
  // The sentence below the picture comes after it.
  await isShown("beside");
  for (const [width, height] of [[1024, 768], [1440, 900], [1920, 1080], [3840, 2160]]) {
    await resize(width, height);
    for (const panel of ["price", "work", "picture", "lights"]) {
      await press(`tab-${panel}`);
      for (const end of [0, 1e6]) {
        await ask((end) => scrollTo(0, end), end);
        const { top, bottom } = await ask(() => document.getElementById("frame").getBoundingClientRect().toJSON());
        must([top, bottom], () => top >= 0 && bottom <= height, `a picture within ${width} x ${height}, beside ${panel}, at ${end}`);
      }
    }
    await ask(() => scrollTo(0, 0));
    const [verify, frame] = await ask(() => ["verify", "frame"].map((id) => document.getElementById(id).getBoundingClientRect().toJSON()));
    must(verify.bottom, (bottom) => bottom < height, `Verify above ${height}`);
    must(frame.width, (wide) => wide > width / 2, `a picture of over half of ${width}`);
  }
});

quick("beside every dial most of the picture is in view, in twelve windows", async () => {
  await open(`${SMALL}#stage?scene=three-point&play=none&lights=0:w3000:apolynomial/1/2/3`);
  await exists("#curve .handle");
  const sizes = [[844, 390], [667, 375], [915, 412], [740, 360], [640, 400], [320, 200], [390, 844], [360, 640], [768, 1024], [1023, 768], [1024, 768], [1200, 700]];
  const areas = new Map();
  for (const [width, height] of sizes) {
    await resize(width, height);
    await until((width) => innerWidth === width, width);
    let dials = 0;
    for (const panel of ["picture", "lights"]) {
      await press(`tab-${panel}`);
      await ask(() => scrollTo(0, 0));
      const seen = await ask(async () => {
        const found = [];
        for (const dial of document.querySelectorAll(".desk input[type=range]")) {
          if (!dial.checkVisibility()) continue;
          dial.focus();
          for (let i = 0; i < 2; i += 1) await new Promise(requestAnimationFrame);
          const [frame, box] = [document.getElementById("frame"), dial].map((element) => element.getBoundingClientRect());
          const tall = Math.min(frame.bottom, innerHeight) - Math.max(frame.top, 0);
          const on = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
          found.push({ id: dial.id, isSeen: on === dial, tall: Math.round(tall), share: tall / frame.height, area: frame.width * frame.height });
        }
        document.activeElement.blur();
        return found;
      });
      dials += seen.length;
      areas.set(width, seen[0].area);
      for (const one of seen) must(one, ({ isSeen, tall, share }) => isSeen && tall >= 160 && share >= 0.4, `a dial and most of the picture, in ${width} x ${height}`);
    }
    must(dials, (dials) => dials >= 8, `at least 8 dials in ${width} x ${height}`);
  }
  must(areas.get(1024) / areas.get(1023), (ratio) => ratio > 0.6, "a picture that hardly shrinks from 1,023 to 1,024 pixels");
});

quick("the tabs of the desk follow the arrow keys", async () => {
  await open(`${SMALL}#stage?scene=bare-spot&play=none`);
  const seen = () => ask(() => [...document.querySelectorAll("[role=tabpanel]")].filter((panel) => panel.checkVisibility()).map(({ id }) => id).join());
  await focus("tab-lights");
  for (const [key, id] of [["ArrowRight", "picture"], ["End", "price"], ["ArrowRight", "lights"], ["ArrowLeft", "price"], ["Home", "lights"]]) {
    await tab.keyboard.press(key);
    assert.deepEqual([await seen(), await ask(() => document.activeElement.id)], [`desk-${id}`, `tab-${id}`], key);
  }
});

quick("the wheel scrolls the page, unless the picture has the focus or with Ctrl", async () => {
  await open(`${SMALL}#stage?scene=show&play=none`);
  await isShown("handle-aim");
  const state = async () => (await written(), hash());
  const before = await state();
  for (const target of ["#view", "#handles .area"]) {
    await ask(() => document.activeElement.blur());
    const middle = await place(target);
    await ask(() => scrollTo(0, 0));
    await tab.mouse.move(...middle);
    await tab.mouse.wheel({ deltaY: 300 });
    await until(() => scrollY > 0);
  }
  assert.equal(await state(), before, "the wheel over the picture changes the state");
  /** Returns whether the picture takes a turn. */
  const turns = (more) =>
    ask((more) => !document.getElementById("view").dispatchEvent(new WheelEvent("wheel", { bubbles: true, cancelable: true, ...more })), more);
  assert.ok(!(await turns({ deltaY: 100 })), "the wheel is taken without the focus");
  assert.ok(await turns({ deltaY: 100, ctrlKey: true }), "the wheel with Ctrl does not zoom");
  const zoomed = await state();
  assert.notEqual(zoomed, before);
  await focus("view");
  assert.ok(await turns({ deltaY: 100 }), "the wheel does not zoom");
  assert.notEqual(await state(), zoomed);
  // At the limit of the zoom the page scrolls, and a swipe always does.
  let taken = 0;
  while (taken < 20 && (await turns({ deltaY: 1000 }))) taken += 1;
  must(taken, () => taken > 0 && taken < 20, "a limit after some turns");
  assert.ok(await turns({ deltaY: -100 }), "the wheel does not zoom back");
  assert.equal(await ask(() => getComputedStyle(document.getElementById("view")).touchAction), "pan-y");
});

quick("a touch that the browser takes leaves camera and lights as they were", async () => {
  await open(`${SMALL}#stage?scene=three-point&play=none`);
  await isShown("handle-0");
  await press("tab-picture");
  const client = await tab.createCDPSession();
  const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  for (const { target, at, changes } of [
    { target: "#view", at: [0.1, 0.9], changes: "&view=" },
    { target: "#handle-0", at: [0.5, 0.5], changes: "&lights=" },
    { target: "#exposure", at: [0.7, 0.5], changes: "&exposure=" },
  ]) {
    await written();
    const before = await hash();
    const [x, y] = await place(target, at);
    await touch("touchStart", { x, y });
    for (const way of [10, 20, 40]) await touch("touchMove", { x: x + way, y });
    await until((changes) => location.hash.includes(changes), changes);
    await touch("touchCancel");
    await until((before) => location.hash === before, before);
    assert.ok(await isDisabled("undo"), "there is a step to undo");
  }
}, { only: "Chromium" });

/** Moves sliders to both ends. Returns what is refused in one of these places. */
const turn = (sliders, places) =>
  ask(
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

quick("both ends of every slider are taken, in every scene and view", async () => {
  await open(`${SMALL}#stage?scene=bare-spot&play=none`);
  await exists("#curve .handle");
  for (const scene of await scenes()) {
    await ask((hash) => void (location.hash = hash), `stage?play=none&scene=${scene}`);
    await until((scene) => window.luminaire.scene === scene, scene);
    for (const [panel, sliders] of [["picture", ["exposure"]], ["lights", ["light-beam", "light-field", "light-intensity"]]]) {
      await press(`tab-${panel}`);
      assert.deepEqual(await turn(sliders, ["light-error", "stage-error"]), [], scene);
    }
  }
  await go("compare");
  assert.deepEqual(await turn(["half-angle"], ["half-angle-error"]), []);
  await go("museum");
  for (const exhibit of await ask(() => Array.from(document.querySelectorAll("input[name=exhibit]"), ({ id }) => id))) {
    await press(exhibit);
    assert.deepEqual(await turn(["exhibit-value"], ["exhibit-error"]), [], exhibit);
  }
});
