import assert from "node:assert/strict";
import { test } from "node:test";
import { aside, isTrap, words } from "../web/failure.js";

test("words are those of an error, or the thrown text itself", () => {
  assert.equal(words(new RangeError("too far")), "too far");
  assert.equal(words("refused"), "refused");
});

test("only an error of the module's machine is a trap", () => {
  assert.ok(isTrap(new WebAssembly.RuntimeError("unreachable")));
  for (const cause of [new Error("no"), "RuntimeError", undefined, null]) assert.ok(!isTrap(cause));
});

test("a failure aside is reported and does not spread", () => {
  const reported = [];
  globalThis.reportError = (error) => reported.push(error.message);
  aside(() => {
    throw new Error("no curve");
  });
  assert.deepEqual(reported, ["no curve"]);
});
