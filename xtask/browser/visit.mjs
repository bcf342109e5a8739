// Opens a page in Chromium, and acts on it when it is ready.
import { writeFileSync } from "node:fs";

import { PATIENCE, chromium, display } from "./launch.mjs";

/**
 * A request has the address, the flags of the browser, a script that runs before the page's own, and whether WebGL is
 * drawn on a virtual display. Acts are expressions to evaluate and pictures to take. Returns the browser's version and
 * the value of each act. It is an error if the page complains on its console.
 */
export async function visit({ address, flags, script, display: needsDisplay }, acts) {
  const screen = needsDisplay ? await display() : undefined;
  const mesa = screen && { DISPLAY: screen.name, LIBGL_ALWAYS_SOFTWARE: "1", GALLIUM_DRIVER: "llvmpipe" };
  const browser = await chromium(flags, mesa);
  try {
    const page = await browser.newPage();
    const complaints = [];
    page.on("pageerror", (error) => complaints.push(error?.stack ?? String(error)));
    page.on("console", (message) => ["error", "assert"].includes(message.type()) && complaints.push(message.text()));
    await page.setViewport({ width: 1440, height: 900 });
    if (script) await page.evaluateOnNewDocument(script);
    await page.goto(address, { waitUntil: "domcontentloaded", timeout: PATIENCE });
    const end = Date.now() + PATIENCE;
    let state = "loading";
    while (state === "loading" && Date.now() < end) {
      await new Promise((resolve) => setTimeout(resolve, 20));
      state = await page.evaluate(() => document.body?.dataset.state ?? "loading");
    }
    const failure = await page.evaluate(() => document.getElementById("failure")?.textContent.trim() ?? "");
    if (state !== "ready") throw new Error(`the page is ${state}: ${[failure, ...complaints].join("\n")}`);
    const values = [];
    for (const { ask, picture } of acts) {
      if (picture) writeFileSync(picture, await page.screenshot());
      values.push(picture ? null : ((await page.evaluate(ask)) ?? null));
    }
    if (complaints.length > 0) throw new Error(`the console has errors:\n${complaints.join("\n")}`);
    return { version: (await browser.version()).replace("/", " "), values };
  } finally {
    await browser.close();
    screen?.end();
  }
}
