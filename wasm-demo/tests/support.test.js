import assert from "node:assert/strict";
import { test } from "node:test";
import * as support from "../web/support.js";

test("the size and the workers are whole numbers, or left out", () => {
  const found = support.requested("?width=320&height=180&workers=0&rest=0");
  assert.deepEqual(found, { width: 320, height: 180, workers: 0, rests: false, refused: [] });
  const none = { width: undefined, height: undefined, workers: undefined, rests: true, refused: [] };
  assert.deepEqual(support.requested(""), none);
  for (const text of ["", "-1", "1.5", "1e3", "wide", "1234567890"]) {
    const { width, height, refused } = support.requested(`?width=${text}&height=9`);
    assert.deepEqual([width, height], [undefined, 9]);
    assert.deepEqual(refused, [`width = "${text}": expected a whole number of pixels`]);
  }
  const { workers, refused } = support.requested("?workers=17");
  assert.deepEqual([workers, refused], [undefined, ['workers = "17": expected 0 to 16 workers']]);
});
