import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const WEB = new URL("../web/", import.meta.url);

test("every picture of the page has a name before it is drawn", () => {
  const texts = readdirSync(WEB).filter((name) => name.endsWith(".html")).map((name) => readFileSync(new URL(name, WEB), "utf8"));
  const pictures = texts.flatMap((text) => text.match(/<[^>]*\brole="(?:img|application)"[^>]*>/g) ?? []);
  assert.ok(pictures.length > 15, `found ${pictures.length} pictures`);
  assert.deepEqual(pictures.filter((tag) => !/\baria-label="[^"]+"/.test(tag)), []);
});
