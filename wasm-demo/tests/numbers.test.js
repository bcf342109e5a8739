import assert from "node:assert/strict";
import { test } from "node:test";
import { ceiling, colours, degrees, floor, median, roughly, tidy, whole } from "../web/numbers.js";

test("tidy keeps two decimals, and three digits of a small value", () => {
  const cases = [[22.4311, 22.43], [-3.005, -3], [0.0123456, 0.0123], [-0.5, -0.5], [0, 0], [1e9, 1e9]];
  for (const [value, shown] of cases) assert.equal(tidy(value), shown);
  assert.ok(Number.isNaN(tidy(NaN)));
});

test("degrees has a minus sign and not a hyphen", () => {
  assert.equal(degrees(-12.345), "−12.35°");
  assert.equal(degrees(7), "7°");
});

test("roughly keeps three significant digits", () => {
  assert.equal(roughly(123.456), "123°");
  assert.equal(roughly(0.0123456), "0.0123°");
});

test("whole has thousands separators", () => assert.equal(whole(1234567.4), "1,234,567"));

test("floor is never above its argument, and ceiling never below", () => {
  for (let i = 0; i < 1000; i += 1) {
    const value = 10 ** (6 * Math.random() - 3);
    assert.ok(floor(value) <= value && value - floor(value) < 0.01 + 1e-9, String(value));
    assert.ok(ceiling(value) >= value * (1 - 1e-12) && ceiling(value) <= value * 1.0101, String(value));
  }
});

test("median is the middle value, or the mean of the middle two", () => {
  assert.equal(median([3, 100, 1]), 3);
  assert.equal(median([10, 9, 1, 2]), 5.5);
  // In order of size and not of their digits.
  assert.equal(median([10, 9, 100]), 10);
});

test("colours has one colour for three bytes", () => {
  assert.deepEqual(colours(Uint8Array.of(1, 2, 3, 250, 0, 9)), ["rgb(1 2 3)", "rgb(250 0 9)"]);
});
