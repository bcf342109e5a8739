// The stage: its pictures, its scenes and effects, its state and the address, and the camera.
import {
  EXPECT, SIZE, STILL, account, ask, assert, change, choose, count, drag, draws, drawn, enter, follow, go, hash, isChecked, isDisabled, isLit,
  isShown, isWritten, more, must, number, open, options, pause, place, press, quick, redraw, resize, scenes, settle, shows, sum, survey,
  tab, until, value, words, written,
} from "./visit.mjs";
import { CHANGES, LINK } from "../passed-on.js";

quick("the page becomes ready without a complaint", async () => {
  await open();
  assert.ok(await ask(() => crossOriginIsolated), "expected a page that is crossOriginIsolated");
  assert.ok(!(await shows("failure")), await words("failure"));
});

quick("the picture is lit by its lights, in several colours", async () => {
  await open();
  must((await survey()).colours, (colours) => colours > 16, "over 16 colours");
  await ask(() => window.probe.keep("lit"));
  for (const light of [0, 1, 2]) await press(`light-${light}-on`);
  await settle();
  await ask(() => window.probe.keep("unlit"));
  const added = await ask(() => window.probe.differences("lit", "unlit"));
  must(added, ({ largest, share }) => largest > 128 && share > 0.2, "lights that add over 128 codes, and reach a fifth of the pixels");
});

/** Waits until the picture has the pixels of the device, or four for each of them. */
const isExact = async (width, density, scale) => {
  const exact = (width, density, scale) => {
    const view = document.getElementById("view");
    const box = view.getBoundingClientRect();
    const along = ["width", "height"].map((side) => view[side] - scale * box[side] * devicePixelRatio);
    return innerWidth === width && devicePixelRatio === density && along.every((pixels) => Math.abs(pixels) <= scale);
  };
  // The window may have its size a moment later, and the picture at rest its own after a while.
  do {
    await until(exact, width, density, scale);
    await settle();
  } while (!(await ask(exact, width, density, scale)));
};

quick("at rest the picture has the resolution of the device, or twice that", async () => {
  for (const [width, height, density, scale] of [[1280, 800, 1, 2], [390, 844, 1, 2], [1200, 900, 2, 1]]) {
    await open("?#stage?play=none&scene=three-point");
    await resize(width, height, density);
    await isExact(width, density, scale);
    await isLit("at rest");
  }
});

more("rest ends with a change", async () => {
  await open("?#stage?play=none&scene=three-point");
  await resize(1280, 800, 2);
  const width = () => document.getElementById("view").width;
  const isAtRest = () => until(() => document.getElementById("view").width > 960);
  for (const act of [
    () => press("light-0-on"),
    () => ask(() => window.probe.enter("exposure", 1)),
    () => ask(() => window.probe.key(document.getElementById("view"), { key: "ArrowLeft" })),
  ]) {
    await isAtRest();
    await ask(() => {
      const view = document.getElementById("view");
      [window.sizes, window.before] = [[], window.luminaire.drawn];
      window.watch = setInterval(() => window.luminaire.drawn > window.before + window.sizes.length && window.sizes.push(view.width));
    });
    await act();
    await until(() => window.sizes.length > 0);
    await isAtRest();
    assert.deepEqual(await ask(() => (clearInterval(window.watch), [window.sizes[0], window.luminaire.drawn - window.before])), [960, 1], String(act));
  }
  await open("?#stage?play=lights&scene=turntable", { plays: true });
  await draws(10);
  assert.equal(await ask(width), 960, "a picture that plays");
});

more("a picture that the canvas refused is shown with the next draw", async () => {
  await open();
  const before = await drawn();
  const told = await ask(async () => {
    const canvas = CanvasRenderingContext2D.prototype;
    const put = canvas.putImageData;
    canvas.putImageData = function (...picture) {
      if (this.canvas.id === "view") throw new Error("out of memory");
      put.apply(this, picture);
    };
    document.getElementById("light-0-on").click();
    await window.luminaire.redraw();
    canvas.putImageData = put;
    return document.getElementById("stage-error").textContent;
  });
  assert.match(told, /out of memory/);
  assert.equal(await drawn(), before, "a refused picture counts as drawn");
  for (const what of ["the refused picture is not shown again", "a picture that was shown is shown again"]) {
    await ask(() => window.luminaire.redraw());
    assert.equal(await drawn(), before + 1, what);
  }
});

const DIVIDED = "?width=960&height=540#stage?scene=three-point&play=none&format=fx16&with=f32&effects=-dither";

quick("the halves of a divided picture differ as on the host", async () => {
  await open(DIVIDED);
  assert.ok(await shows("divided"), "the picture is whole");
  const difference = () => ask(() => window.luminaire.difference);
  const { largest, place, differing } = await difference();
  assert.deepEqual({ largest, place, differing }, EXPECT.divided);
  must(largest, (largest) => largest > 0, "two pictures");
  assert.match(await words("divided-note"), new RegExp(`^16-bit integers: .* differ from 32-bit floats, by .*${largest}( of 255)? \\(ring`));
  await enter("divided-format", "fx16");
  const same = await difference();
  assert.deepEqual([same.largest, same.differing], [0, 0], "a format differs from itself");
  await enter("divided-format", "");
  assert.ok(!(await shows("divided")) && (await ask(() => window.luminaire.difference === undefined)), "it stays divided");
});

more("a divided picture is covered by its difference, and kept by the address", async () => {
  await open(DIVIDED.replace("format=fx16&with=f32", "format=f32&with=fx16"));
  const cover = () => shows("divided-difference");
  assert.ok(!(await cover()), "the difference covers the picture at first");
  await press("divided-cover");
  assert.ok(await cover(), "the switch does not cover the picture");
  must(await isWritten(/difference=1/), (address) => ["format=f32", "with=fx16"].every((part) => address.includes(part)), "both formats in the address");
  await press("undo");
  assert.ok(!(await cover()), "undo leaves the picture covered");
  // A beam that the other format cannot hold is refused.
  await enter("light-field-number", 0.5);
  assert.notEqual(await words("light-error"), "", "a beam of half a degree is taken in 16 bits");
});

quick("every scene is drawn, with its account", async () => {
  await open("#stage?play=none");
  const titles = new Set();
  const names = await scenes();
  must(names, (names) => names.length > 7, "over 7 scenes");
  for (const name of names) {
    await choose(name);
    assert.equal(await ask(() => window.luminaire.scene), name);
    await isLit(name);
    const told = await account();
    const parts = ["evaluated", "missedByRow", "missedByTile", "kept", "dropped"].reduce((sum, part) => sum + told[part], 0);
    must(told, ({ pairs, evaluated }) => parts === pairs && evaluated > 0, `${name}: an account that adds up to ${parts} pairs`);
    assert.match(await words("account-ratio"), /^1 in /, name);
    assert.match(await words("frame-ms"), / ms$/, name);
    titles.add(await words("summary"));
  }
  must([...titles], (titles) => titles.length > 7, "over 7 titles");
});

quick("every display is shown, by square pixels of a small one, and kept by the address", async () => {
  await open("?#stage?play=none&scene=pocket");
  assert.equal(await value("display"), "rgb565");
  const colors = () =>
    ask(() => {
      const codes = window.luminaire.pixels();
      return new Set(Array.from({ length: codes.length / 4 }, (_, i) => codes.slice(4 * i, 4 * i + 3).join())).size;
    });
  for (const name of await options("display")) {
    await enter("display", name);
    await settle();
    const most = { gray1: 2, gray2: 4, gray4: 16, acep: 7 }[name] ?? Infinity;
    must(await colors(), (colors) => colors > 1 && colors <= most, `${name}: at most ${most} colours`);
  }
  const shown = await ask(() => {
    const view = document.getElementById("view");
    return [view.width, (view.clientWidth / 160) % 1, (view.clientHeight / 120) % 1, getComputedStyle(view).imageRendering];
  });
  assert.deepEqual(shown, [160, 0, 0, "pixelated"]);
  await enter("display", "gray2");
  const [address, picture] = [await isWritten(/display=gray2/), await sum()];
  await open(`?${address}`);
  assert.deepEqual([await value("display"), await sum()], ["gray2", picture]);
  await choose("three-point");
  assert.deepEqual([await value("display"), await shows("leds")], ["rgb888", false]);
});

quick("one sentence says what 16 bits change in the picture, and leads to the place", async () => {
  const told = () => until(() => document.getElementById("verdict-text").textContent);
  await open("#stage?scene=turntable&play=none");
  assert.match(await told(), /^16 bits: [\d.]+ % of the pixels differ from 32-bit floats, by at most 1 of 255; 1[2-4] % of the best floats' instructions on an M0\.$/);
  // Beside the edges of shadows more than rounding differs.
  await open("#stage?scene=three-point&play=none&format=f32");
  assert.match(await told(), /, by 1 of 255, and \d+ of them by up to \d+; /);
  await press("beside");
  await press("verdict-where");
  assert.ok(!(await shows("verdict-where")), "a way to where the visitor is");
  await settle();
  must(await isWritten(/difference=1/), (address) => address.includes("with=fx16"), "the other format in the address");
  assert.ok(await shows("divided-ring"), "a ring around the largest difference");
});

/** Opens the page as a new visitor, and notes each place of the edge while the picture is divided. */
const arrive = async (address = SIZE) => {
  const script = `window.edges = []; setInterval(() => {
    const [frame, divided] = ["frame", "divided"].map((id) => document.getElementById(id));
    if (divided && !divided.hidden) window.edges.push(parseFloat(frame.style.getPropertyValue("--split")));
  }, 20)`;
  await open(address, { plays: true, script });
  await isShown("beside");
};

quick("the edge between integers and floats moves over the first picture, until it is touched", async () => {
  await arrive();
  await until(() => window.edges.at(-1) < 50);
  const names = await ask(() => [...document.querySelectorAll("#divided .badge")].map(({ textContent }) => textContent));
  assert.deepEqual([names, await shows("divided-note")], [["16-bit integers", "32-bit floats"], false]);
  await tab.mouse.move(...(await place("#view", [0.5, 0.02])));
  await tab.mouse.down();
  await tab.mouse.up();
  assert.ok(!(await shows("divided")), "an edge over a picture that was pressed");
  must(await isWritten(/scene=show|play=|^#stage/), (address) => !address.includes("with="), "an address that is not divided");
  // It is one press away.
  await press("beside");
  await until(() => document.getElementById("frame").style.getPropertyValue("--split") === "50%");
  await isWritten(/with=f32/);
  assert.deepEqual([await words("beside"), await shows("divided-note")], ["Show whole", true]);
  await press("beside");
  assert.deepEqual([await words("beside"), await shows("divided")], ["Compare", false]);
});

more("the edge moves over the first picture once, and not where it is unwanted", async () => {
  await arrive();
  await until(() => window.edges.length > 0 && document.getElementById("divided").hidden);
  const edges = await ask(() => window.edges);
  must([Math.min(...edges), edges.at(-1)], ([least, last]) => least < 10 && last > 90, "an edge that goes over the picture and back");
  const before = edges.length;
  await draws(3);
  await press("scene-turntable");
  await pause(1500);
  assert.equal(await ask(() => window.edges.length), before, "an edge for another scene");
  const still = "window.matchMedia = (query) => ({ matches: query.includes('reduced-motion') })";
  for (const [address, script] of [[`${SIZE}#stage?scene=show`], [SIZE, still]]) {
    await open(address, { plays: true, script });
    await isShown("beside");
    await pause(1500);
    assert.ok(!(await shows("divided")), `a divided picture at ${address}, ${script}`);
  }
});

quick("a tree of LEDs tells its current, which has a limit, in every format", async () => {
  await open("#stage?play=none&scene=tree");
  for (const format of ["f32", "fx16", "fx32"]) {
    await enter("format", format);
    await enter("exposure", 0);
    await settle();
    assert.match(await words("leds"), /^500 LEDs take 7\.8\d A\. The limit is 8 A\.$/, format);
    await change("darker lights", () => enter("exposure", -3));
    assert.match(await words("leds"), /^500 LEDs take [12]\.\d\d A\./, format);
  }
});

more("a picture of the required effects is that of everything, bit for bit", async () => {
  await open("#stage?play=none");
  await press("verify");
  await until(() => document.getElementById("equality").textContent.includes("are equal, bit for bit"));
  const before = await sum();
  await redraw("the switch", () => press("everything"));
  assert.equal(await sum(), before, "evaluating everything changes the picture");
  must(await account(), ({ evaluated, pairs }) => evaluated === pairs, "everything to be evaluated");
  assert.equal(await words("account-ratio"), "1 in 1");
});

quick("a scene is opened by its address, and kept while another view is open", async () => {
  await open("#stage?play=none&scene=grid");
  const scene = () => ask(() => window.luminaire.scene);
  assert.ok((await scene()) === "grid" && (await isChecked("scene-grid")), await scene());
  await choose("three-point");
  await isWritten(/^#stage\?v=1&scene=three-point&play=none$/);
  await redraw("the address", () => ask(() => void (location.hash = "#stage?scene=turntable&play=none")));
  assert.equal(await scene(), "turntable");
  await enter("map-subject", "tiles");
  await isWritten(/^#stage\?v=1&scene=turntable&play=none&map=tiles$/);
  const title = await tab.title();
  for (const [view, id] of [["compare", "comparison"], ["stage", "stage-page"]]) {
    await follow(view);
    await isShown(id);
    await settle();
    const found = await ask(() => [document.querySelector(".views [aria-current]").hash.split("?")[0], document.activeElement.id]);
    assert.deepEqual(found, [`#${view}`, id], "the current link, and the focus");
    assert.deepEqual([await shows("view"), await shows("comparison")], [view === "stage", view !== "stage"]);
    assert.equal((await tab.title()) === title, view === "stage", await tab.title());
  }
  assert.equal(await scene(), "turntable", "the scene after coming back");
  await change("a light, after coming back", () => press("light-0-on"));
  // An address of an earlier page, whose scenes were a view of their own.
  await open("#scenes?scene=pocket&map=lights");
  assert.equal(await scene(), "pocket");
  assert.ok(await shows("map-bar"), "an old link has no map");
});

quick("every setting is kept by the address", async () => {
  await open();
  const settings = { "light-beam-number": 17, "light-color": "#40ff80", "light-intensity-number": 120, exposure: 0.5, format: "fx32" };
  for (const [id, value] of Object.entries(settings)) await enter(id, value);
  await press("light-1-on");
  await press("effect-haze");
  await drag(await place("#view"), [70, 12]);
  await written();
  const [address, picture] = [await isWritten(/view=.*:b17:/), await sum()];
  assert.match(address, /^#stage\?v=1&scene=three-point&format=fx32&view=/);
  await open(address);
  assert.equal(await words("stage-error"), "", address);
  assert.equal(await sum(), picture, `${address} opens another picture`);
  assert.deepEqual([await number("light-beam-number"), await number("exposure"), await isChecked("light-1-on")], [17, 0.5, false]);
});

quick("an address that was passed on opens the same picture", async () => {
  await open(`?workers=0&rest=0&width=64&height=36${LINK}`);
  await written();
  const [expected, address] = [await sum(), await hash()];
  for (const [name, change] of Object.entries(CHANGES)) {
    await go("stage?scene=bare-spot&play=none");
    await redraw(name, () => ask((hash) => void (location.hash = hash), change(LINK)));
    assert.deepEqual([await sum(), await words("stage-error")], [expected, ""], name);
  }
  await written();
  assert.equal(await hash(), address);
  await open(`?fbclid=IwAR0&workers=0&rest=0&width=64&height=36&utm_source=x${LINK}`);
  assert.deepEqual([await sum(), await shows("trouble")], [expected, false], "with parameters before the #");
});

more("a bad part of an address is refused in words, and the page goes on", async () => {
  const still = "#stage?play=none&scene=three-point";
  for (const [address, id, told] of [
    ["#stage?play=none&scene=nowhere", "stage-error", /scene = "nowhere"/],
    [`${still}&lights=0:b0.1&format=fx16`, "stage-error", /16-bit fixed point cannot hold light 1/],
    [`${still}&lights=%3Cimg%20onerror%3E`, "stage-error", /lights/],
    [`?workers=99&rest=0&width=64&height=36${still}`, "trouble", /^workers = "99": expected 0 to 16 workers\./],
    [`?workers=0&width=0&height=36${still}`, "trouble", /^width = 0: expected 1 to 8192 pixels\./],
    [`?workers=0&width=64${still}`, "trouble", /^height = 0: expected 1 to 8192 pixels\./],
    [`?workers=0&width=8192&height=8192${still}`, "trouble", /^height = 8192: expected 1 to \d+ pixels\./],
  ]) {
    await open(address);
    assert.match(await words(id), told, address);
    await isLit(address);
  }
  await open(`${still}&lights=0:x;1:<img/src>;2&map=<img/src>`);
  assert.match(await words("stage-error"), /lights = "1:.*": expected a light of the scene.*subject of the map = /);
  assert.deepEqual([await count("#stage-error *"), await words("lights-count")], [0, "2 of 3 on"]);
});

quick("changes are undone, redone and reset", async () => {
  await open();
  assert.ok((await isDisabled("undo")) && (await isDisabled("redo")), "there is something to undo");
  const opened = await sum();
  await change("a beam", () => enter("light-beam-number", 12));
  const narrow = await sum();
  await isWritten(/:b12/);
  await change("a light", () => press("light-0-on"));
  await change("undo", () => press("undo"));
  assert.equal(await sum(), narrow, "undo leads to another picture");
  await change("undo by keys", () => ask(() => window.probe.key(document.body, { key: "z", ctrlKey: true })));
  assert.ok((await sum()) === opened && (await isDisabled("undo")), "undo does not lead back");
  await change("redo", () => press("redo"));
  assert.equal(await sum(), narrow, "redo leads to another picture");
  await change("reset", () => press("reset"));
  assert.equal(await sum(), opened, "reset does not lead back");
  await change("undo of the reset", () => press("undo"));
});

quick("the page opens on the show, which plays unless motion is unwanted", async () => {
  await open("", { plays: true });
  assert.equal(await ask(() => window.luminaire.scene), "show");
  await isLit("when the page is ready");
  await draws(3);
  await press("play");
  await settle();
  await isWritten(/play=none/);
  await open("?width=480&height=270", { script: "window.matchMedia = (query) => ({ matches: query.includes('reduced-motion') })", plays: true });
  await settle();
  assert.deepEqual([await drawn(), await isChecked("play")], [1, false], "pictures for a visitor who wants no motion");
});

quick("a scene plays, and stops", async () => {
  await open("#stage?play=none&scene=turntable");
  for (const id of ["play", "camera"]) {
    const before = await sum();
    await press(id);
    await draws(4);
    await press(id);
    await settle();
    assert.notEqual(await sum(), before, `${id} leaves the picture as it was`);
  }
  await choose("bare-spot");
  assert.deepEqual([await isDisabled("play"), await isDisabled("camera")], [true, true], "where nothing moves");
});

more("the camera is moved by mouse and keys, and reset", async () => {
  await open();
  const opened = await sum();
  const middle = await place("#view");
  const turn = (way) => () => drag(middle, way);
  await change("dragging", turn([90, 20]));
  await ask(() => document.getElementById("view").focus());
  await tab.mouse.move(...middle);
  await change("the wheel", () => tab.mouse.wheel({ deltaY: 120 }));
  for (const key of ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown"]) await change(key, () => tab.keyboard.press(key));
  for (const act of [
    () => window.probe.key(document.getElementById("view"), { key: "r" }),
    () => document.getElementById("view").dispatchEvent(new MouseEvent("dblclick")),
  ]) {
    await change(String(act), () => ask(act));
    assert.equal(await sum(), opened, `${act} leads to another picture`);
    await change("dragging", turn([40, 20]));
  }
});

more("lights and effects of a scene are switched", async () => {
  await open("#stage?play=none&scene=turntable");
  // Dither is on at first.
  for (const [effect, isOn] of [["haze", false], ["dither", true]]) {
    for (const before of [isOn, !isOn]) {
      assert.equal(await isChecked(`effect-${effect}`), before, effect);
      await change(effect, () => press(`effect-${effect}`));
    }
  }
  await change("shadows put in", () => press("effect-shadow"));
  assert.match(await words("shadows-ms"), / ms$/);
  await change("shadows left out", () => press("effect-shadow"));
  const before = await account();
  must(before, ({ evaluatedShining }) => evaluatedShining > 0, "highlights");
  await change("highlights left out", () => press("effect-specular"));
  must(await account(), ({ evaluatedShining }) => evaluatedShining === 0, "no highlights");
  await change("a light switched off", () => press("light-0-on"));
  must(await account(), ({ lightsDropped, dropped }) => lightsDropped === 1 && dropped !== before.dropped, "one light dropped");
  await change("all lights off", () => press("all-off"));
  assert.equal(await words("account-ratio"), "none", "in the dark");
  await change("all lights on", () => press("all-on"));
  assert.equal(await words("lights-count"), "8 of 8 on");
  await choose("show");
  await change("gobos left out", () => press("effect-gobo"));
  await choose("grid");
  for (const effect of ["specular", "gobo", "shadow"]) assert.ok(await isDisabled(`effect-${effect}`), `the grid has the switch of ${effect}`);
});

more("the map shows how many lights were evaluated, with a legend", async () => {
  await open("#stage?play=none&scene=grid");
  assert.ok(!(await shows("map")) && !(await shows("map-lights")), "there is a map at first");
  await enter("map-subject", "lights");
  assert.ok((await shows("map")) && (await shows("map-bar")), "the map or its legend is not shown");
  assert.match(await words("map-end"), / lights$/);
  must(await ask(() => new Set(new Uint32Array(window.probe.map().buffer)).size), (colours) => colours > 2, "over 2 colours in the map");
  await redraw("the switch", () => press("everything"));
  assert.equal(await words("map-end"), "64 lights");
  await enter("map-subject", "nothing");
  assert.ok(!(await shows("map")), "the map stays");
});

/** Fails unless the times of the passes add up to that of the frame, but for those that are marked as kept. */
async function addsUp(...kept) {
  // All are read in one call, because the next picture has other times.
  const told = await ask(() => {
    const places = ["geometry", "shadows", "lighting", "encode", "transfer", "show", "frame"].map((pass) => [pass, document.getElementById(`${pass}-ms`)]);
    return places.flatMap(([pass, place]) => (place ? [{ pass, text: place.textContent, isGrey: place.classList.contains("kept") }] : []));
  });
  const isKept = ({ text }) => text.endsWith(" kept");
  assert.deepEqual(told.filter(isKept).map(({ pass }) => pass), kept, JSON.stringify(told));
  must(told.filter(isKept), (all) => all.every(({ isGrey }) => isGrey), "times that were kept in grey");
  const times = told.filter((time) => !isKept(time) && time.text !== "–").map(({ text }) => Number(text.match(/^([\d.]+) ms$/)?.[1]));
  const frame = times.pop();
  must(times.reduce((sum, time) => sum + time, 0), (sum) => Math.abs(sum - frame) <= 0.01 * frame, `passes that add up to ${frame} ms`);
}

more("a time that is not of the last picture says so, and the others add up", async () => {
  await open(`?rest=0${STILL}`);
  await addsUp();
  await change("the beam", () => enter("light-beam-number", 12));
  await addsUp();
  await change("a drag", async () => drag(await place("#view"), [60, 10]));
  await addsUp("shadows");
  await enter("format", "f32");
  await addsUp();
  await open("?rest=0#stage?play=none&scene=three-point");
  await addsUp();
  await press("scene-turntable");
  await press("play");
  await draws(8);
  await addsUp("geometry");
  assert.equal(await words("shadows-ms"), "–", "a scene without shadows");
});

more("a hidden page draws nothing, and goes on when it is seen", async () => {
  await open("?width=320&height=180#stage?scene=show", { plays: true });
  await draws(3);
  // Another tab before the page.
  await ask(() => void (window.other = open("about:blank")));
  await until(() => document.hidden);
  // The picture that was being drawn may still end.
  await until(() => !window.luminaire.isDrawing);
  await pause(500);
  const before = await drawn();
  await pause(2000);
  assert.equal(await drawn(), before, "pictures are drawn while nobody sees them");
  await ask(() => window.other.close());
  await draws(3);
});
