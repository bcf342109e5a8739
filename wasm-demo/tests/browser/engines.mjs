// What the page promises in every engine, also in WebKit's, for which this is all.
import { chromium } from "../../../xtask/browser/launch.mjs";
import { probe } from "./probe.mjs";
import { ENGINE, PAGE, SIZE, ask, assert, change, drag, draws, enter, isLit, number, open, place, press, quick, settle, shows, sum, works, words, written } from "./visit.mjs";

/** The pictures that all engines must draw alike: each effect in each number format. */
const PICTURES = ["scene=show", "scene=three-point&format=f32", "scene=three-point&format=fx32", "scene=three-point&format=fx16"];

quick("pictures have the bits of Chromium's", async () => {
  const browser = await chromium();
  try {
    for (const picture of PICTURES) {
      const address = `#stage?play=none&${picture}`;
      await open(address);
      await isLit(address);
      const found = await ask(() => window.probe.digest());
      const page = await browser.newPage();
      await page.evaluateOnNewDocument(probe);
      await page.goto(PAGE + SIZE + address);
      await page.waitForFunction(() => document.body.dataset.state === "ready", { timeout: 300_000 });
      await page.evaluate(() => window.probe.settle());
      assert.equal(found, await page.evaluate(() => window.probe.digest()), `the SHA-256 of ${address}`);
      await page.close();
    }
  } finally {
    await browser.close();
  }
});

quick("the field slider changes the picture, and a scene plays", async () => {
  await open("#stage?play=none&scene=turntable");
  await change("the field slider", async () => enter("light-field", (await number("light-field")) - 0.2));
  const before = await sum();
  await press("play");
  await draws(4);
  await press("play");
  await settle();
  assert.notEqual(await sum(), before, "the scene does not play");
});

/** WebKit refuses a page's 101st change of its address within ten seconds. */
quick("the page outlives the engine's limit of new addresses", async () => {
  const spend = async () => {
    const found = await ask(() => {
      try {
        for (let i = 0; i < 1000; i += 1) history.replaceState(null, "", location.hash);
      } catch (error) {
        return error.name;
      }
      return "none";
    });
    assert.equal(found, ENGINE === "WebKit" ? "SecurityError" : "none", "what refuses a thousand addresses");
  };
  await open();
  await spend();
  await change("a beam", () => enter("light-beam-number", 15));
  for (const by of [40, -30]) {
    await change("a drag", async () => drag(await place("#view"), [by, 10]));
    await spend();
  }
  await written();
  await works();
  assert.ok(!(await shows("trouble")), await words("trouble"));
});
