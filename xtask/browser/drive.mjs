// Opens a page in Chromium for a command of the laboratory. Standard input has the request as JSON: the address, the
// flags, a script that runs before the page's own, whether WebGL is drawn on a virtual display, and acts, which are
// expressions to evaluate and pictures to take. Prints the browser's version and the value of each act.
import { writeFileSync } from "node:fs";
import { text } from "node:stream/consumers";

import { PATIENCE, chromium, display } from "./launch.mjs";

const { address, flags, script, display: needsDisplay, acts } = JSON.parse(await text(process.stdin));

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
  console.log(JSON.stringify({ version: (await browser.version()).replace("/", " "), values }));
} finally {
  await browser.close();
  screen?.end();
}
