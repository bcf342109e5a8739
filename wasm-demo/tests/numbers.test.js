import assert from "node:assert/strict";
import { test } from "node:test";
import { colours, degrees, median, tidy, whole } from "../web/numbers.js";

test("tidy keeps two decimals, and three digits of a small value", () => {
  const cases = [[22.4311, 22.43], [-3.005, -3], [0.0123456, 0.0123], [-0.5, -0.5], [0, 0], [1e9, 1e9]];
  for (const [value, shown] of cases) assert.equal(tidy(value), shown);
  assert.ok(Number.isNaN(tidy(NaN)));
});

test("degrees has a minus sign and not a hyphen", () => {
  assert.equal(degrees(-12.345), "−12.35°");
  assert.equal(degrees(7), "7°");
});

test("whole has thousands separators", () => assert.equal(whole(1234567.4), "1,234,567"));

test("median is the middle value, or the mean of the middle two", () => {
  assert.equal(median([3, 100, 1]), 3);
  assert.equal(median([10, 9, 1, 2]), 5.5);
  // In order of size and not of their digits.
  assert.equal(median([10, 9, 100]), 10);
});

test("colours has one colour for three bytes", () => {
  assert.deepEqual(colours(Uint8Array.of(1, 2, 3, 250, 0, 9)), ["rgb(1 2 3)", "rgb(250 0 9)"]);
});
