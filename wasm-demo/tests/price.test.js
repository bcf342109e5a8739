import assert from "node:assert/strict";
import { test } from "node:test";
import { front } from "../web/price-chart.js";
import { described, picture } from "../web/price-panel.js";

test("front keeps the points that no other beats", () => {
  const points = [2, 0.5, 0.5, 0.75, 0.01].map((error, i) => ({ cost: 100 * (i + 1), error }));
  assert.deepEqual(front(points).map(({ cost }) => cost), [100, 200, 500]);
});

test("described states angles and distances as the picker knows them", () => {
  const light = { beam: 10, field: 20, edge: "own", ownEdge: "hard", intensity: 3 };
  assert.deepEqual(described(light, [1, 2]), { edge: "hard", field: 20, intensity: 3, near: 1, far: 2 });
  const fitted = { beam: 10, field: 20, intensity: 3, near: 2, far: 8 };
  assert.deepEqual(described({ ...light, ownEdge: "linear", throw: 4 }), fitted);
});

test("picture adds the lit points to the rest of a picture", () => {
  const chip = { megahertz: 2, rest: { f32: { instructions: 500, cycles: 700 } } };
  const found = picture({ reached: 10 }, chip, "f32", { instructions: 50, cycles: 130 });
  assert.deepEqual(found, { instructions: 1000, cycles: 2000, milliseconds: 1 });
});
