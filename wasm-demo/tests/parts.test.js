import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import { setImmediate as turn } from "node:timers/promises";

/** How the server answers: with a list of parts, with a status, or not at all. */
let answer;
/** How often the list was requested. */
let requests;

globalThis.document = { body: { dataset: {} } };
globalThis.fetch = async (address) => {
  assert.equal(address, "parts.json");
  requests += 1;
  if (answer === undefined) throw new TypeError("Failed to fetch");
  return typeof answer === "number" ? new Response("", { status: answer }) : Response.json({ parts: answer });
};
mock.timers.enable({ apis: ["setTimeout"] });

/** Lets a second pass, in which the list is requested once, and its answer arrive. */
async function second() {
  mock.timers.tick(1000);
  await turn();
}

let parts;
beforeEach(async (context) => {
  document.body.dataset = { parts: "parts.json" };
  requests = 0;
  parts = await import(`../web/parts.js?${context.name}`);
});

const part = (name, state, reason) => ({ name, state, reason });

/** Waits for a part. Returns what was told, and the outcome once there is one. */
function wait(name) {
  const found = { told: [], outcome: undefined };
  const set = (outcome) => (found.outcome = outcome);
  parts.built(name, (text) => found.told.push(text)).then(() => set("built"), ({ message }) => set(message));
  return found;
}

test("a page that is built whole waits for nothing and requests no list", async () => {
  document.body.dataset = {};
  assert.ok(parts.isBuilt("wide"));
  const chip = wait("chip");
  await turn();
  assert.deepEqual([chip, requests], [{ told: [], outcome: "built" }, 0]);
});

test("a part is waited for with one request a second until it is built", async () => {
  answer = [part("stage", "built"), part("wide", "building"), part("class", "waiting")];
  const waiting = [wait("class")];
  await turn();
  // Who comes later is told at once.
  waiting.push(wait("wide"));
  await turn();
  assert.deepEqual(waiting.map(({ told }) => told.at(-1)), [
    "The class is not built yet: 1 of 3 parts is ready. It opens by itself.",
    "The 32-bit renderer is being built: 1 of 3 parts is ready. Until then the picture is drawn in 16 bits.",
  ]);
  answer = [part("stage", "built"), part("wide", "built"), part("class", "building")];
  await second();
  assert.deepEqual([parts.isBuilt("wide"), waiting[1].outcome, waiting[0].outcome], [true, "built", undefined]);
  assert.equal(waiting[0].told.at(-1), "The class is being built: 2 of 3 parts are ready. It opens by itself.");
  answer = answer.map(({ name }) => part(name, "built"));
  await second();
  assert.deepEqual([waiting[0].outcome, requests], ["built", 4]);
  for (let i = 0; i < 5; i += 1) await second();
  assert.equal(requests, 4, "requests while nobody waits");
});

test("a part that has failed says why, and is asked for again", async () => {
  answer = [part("stage", "built"), part("chip", "failed", "no linker was found")];
  const first = wait("chip");
  await turn();
  assert.equal(first.outcome, "The chip could not be built: no linker was found. Run `cargo demo` again once that is mended.");
  answer = [part("stage", "built"), part("chip", "built")];
  await second();
  const again = wait("chip");
  await turn();
  assert.deepEqual(again, { told: [], outcome: "built" });
});

test("a server that does not answer is given up after four tries, and asked again by the next who waits", async () => {
  for (const silence of [undefined, 500]) {
    answer = silence;
    const chip = wait("chip");
    await turn();
    for (let i = 0; i < 2; i += 1) await second();
    assert.equal(chip.outcome, undefined, "after three tries");
    await second();
    assert.match(chip.outcome, /server of the demo does not answer.*cargo demo/);
    await second();
  }
  assert.equal(requests, 8);
  answer = [part("chip", "waiting")];
  const chip = wait("chip");
  await turn();
  assert.equal(chip.told.length, 1);
  // Only tries in a row count.
  for (const list of [[part("chip", "waiting")], [part("chip", "built")]]) {
    answer = undefined;
    for (let i = 0; i < 3; i += 1) await second();
    answer = list;
    await second();
  }
  assert.equal(chip.outcome, "built");
});

test("a list that is gone, or does not name a part, leaves nothing to wait for", async () => {
  for (answer of [404, [part("stage", "built")]]) {
    const chip = wait("chip");
    await turn();
    assert.equal(chip.outcome, "built");
    await second();
  }
});
