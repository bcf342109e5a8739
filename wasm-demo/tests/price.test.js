import assert from "node:assert/strict";
import { test } from "node:test";
import { front } from "../web/price-chart.js";
import { described, picture } from "../web/price-panel.js";

test("front keeps the points that no other beats", () => {
  const points = [2, 0.5, 0.5, 0.75, 0.01].map((error, i) => ({ cost: 100 * (i + 1), error }));
  assert.deepEqual(front(points).map(({ cost }) => cost), [100, 200, 500]);
});

test("described has the light as it is, in units of full scale, and distances", () => {
  const own = { name: "light_1", kind: "point", intensity: 900, attenuation: { law: "decay" }, near: 1, far: 9 };
  const light = { kind: "point", intensity: 3, attenuation: { law: "decay" } };
  assert.deepEqual(described(own, { intensity: 3 }, [1, 2]), { light, near: 1, far: 2 });
  assert.deepEqual(described(own, { intensity: 3, throw: 4 }), { light, near: 2, far: 8 });
});

test("picture adds the lit points to the rest of a picture", () => {
  const chip = { megahertz: 2, rest: { f32: { instructions: 500, cycles: 700 } } };
  const found = picture({ reached: 10 }, chip, "f32", { instructions: 50, cycles: 130 });
  assert.deepEqual(found, { instructions: 1000, cycles: 2000, milliseconds: 1 });
});
