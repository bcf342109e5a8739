import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

/** Returns the text of a file of the page without comments, and nothing of a file that the build adds. */
function read(name) {
  if (name.startsWith("pkg/")) return "";
  return readFileSync(new URL(`../web/${name}`, import.meta.url), "utf8").replace(/<!--[^]*?-->|\/\*[^]*?\*\/|^ *\/\/.*/gm, "");
}

/** The groups that a pattern finds in a file. */
const found = (name, pattern) => Array.from(read(name).matchAll(pattern), ([, group]) => group);

/** Adds what scripts import, and the workers that they start, to a set of their names. */
function follow(name, into) {
  if (into.has(name)) return into;
  into.add(name);
  for (const other of found(name, /(?:^import|^export|\bfrom|new URL\() ?"\.\/([^"]+\.js)"/gm)) follow(other, into);
  return into;
}

test("the page names every script of the first picture, so that none waits for another", () => {
  const [named] = found("index.html", /<script type="module" src="([^"]+)"/g);
  const later = found(named, /\bload\("([^"]+)"\)/g);
  assert.deepEqual(later, ["show.js"]);
  const first = [...follow(later[0], follow(named, new Set()))];
  assert.ok(first.includes("worker.js") && first.length > 30, first.join());
  assert.deepEqual(found("index.html", /<link rel="modulepreload" href="([^"]+)">/g), first.sort());
});
