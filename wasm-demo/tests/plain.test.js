import assert from "node:assert/strict";
import { test } from "node:test";
import { plain } from "../web/plain.js";

test("plain copies the getters of an object, and frees it", () => {
  let freed = 0;
  class Light {
    get beam() {
      return 10;
    }

    get name() {
      return undefined;
    }

    free() {
      freed += 1;
    }
  }
  assert.deepEqual(plain(new Light()), { beam: 10, name: undefined });
  assert.equal(freed, 1);
});
