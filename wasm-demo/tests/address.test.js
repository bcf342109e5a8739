import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import { follow, remember, requestedView } from "../web/address.js";
import { CHANGES, LINK, STATE } from "./passed-on.js";

/** The addresses that were written. */
const written = [];
globalThis.history = { replaceState: (_state, _title, hash) => written.push(hash) };

mock.timers.enable({ apis: ["setTimeout"] });
beforeEach(() => (written.length = 0));

test("the last state is written once, when the visitor pauses", () => {
  follow("stage");
  for (let i = 0; i < 100; i += 1) {
    remember("stage", () => `beam=${i}`);
    mock.timers.tick(200);
  }
  assert.deepEqual(written, []);
  mock.timers.tick(50);
  assert.deepEqual(written, ["#stage?beam=99"]);
});

for (const [name, change] of Object.entries(CHANGES)) {
  test(`an address is read ${name}`, () => {
    const { name: view, query } = requestedView(change(LINK));
    const own = [...new URLSearchParams(STATE)];
    const names = new Set(own.map(([name]) => name));
    assert.deepEqual([view, [...new URLSearchParams(query)].filter(([name]) => names.has(name))], ["stage", own]);
  });
}

test("an address without a state, and one whose last value is empty, are read", () => {
  const read = (hash) => Object.values(requestedView(hash));
  for (const hash of ["", "#", "#?"]) assert.deepEqual(read(hash), ["", ""]);
  for (const hash of ["#museum", "#museum?", "museum."]) assert.deepEqual(read(hash), ["museum", ""]);
  assert.deepEqual(read("#stage?lights=)."), ["stage", "lights="]);
  assert.deepEqual(read("#class?d=%zz%e9&#9999999;&c=1"), ["class", "d=%zz%e9&9999999;&c=1"]);
});

test("only the current view writes", () => {
  follow("stage");
  remember("compare", () => "half=1");
  remember("stage", () => "beam=1");
  follow("compare");
  mock.timers.tick(1000);
  assert.deepEqual(written, []);
});

test("a browser that refuses an address is not an error, and is asked again", () => {
  const info = mock.method(console, "info", () => {});
  const refusal = mock.method(history, "replaceState", () => {
    throw new Error("more than 100 times");
  });
  follow("stage");
  remember("stage", () => "beam=1");
  mock.timers.tick(1000);
  assert.match(info.mock.calls[0].arguments[0], /more than 100 times/);
  refusal.mock.restore();
  assert.deepEqual(written, []);
  mock.timers.tick(10_000);
  assert.deepEqual(written, ["#stage?beam=1"]);
});
