// A server of the demo that is still building it, as `cargo demo` does at first: the files of a part
// are missing until it is built, and the page has the address of a list of all parts.
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";

import { EXPECT } from "./visit.mjs";

/** The files of each part. */
const FILES = {
  stage: /^pkg\/wasm_demo/,
  wide: /^pkg\/wide/,
  price: /^price\//,
  code: /^pkg\/code/,
  comparison: /^pkg\/comparison/,
  class: /^pkg\/class/,
  files: /^pkg\/files/,
  chip: /^(chip\/|chip-worker|chip-licenses|rp2040)/,
};

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm", ".svg": "image/svg+xml" };

/**
 * Serves the demo. `states` has the parts that are not built, each with its state in the list or with
 * the reason why it has failed. It may change at any time.
 */
export async function serveParts(states) {
  const list = () =>
    Object.keys(FILES).map((name) => {
      const state = states[name] ?? "built";
      return ["built", "building", "waiting"].includes(state) ? { name, state } : { name, state: "failed", reason: state };
    });
  const content = (name) => {
    if (name === "parts.json") return JSON.stringify({ parts: list() });
    if (list().some((part) => part.state !== "built" && FILES[part.name].test(name))) throw new Error(`${name} is not built`);
    const file = readFileSync(join(EXPECT.site, name));
    return name === "index.html" ? String(file).replace('<body data-state="loading"', '$& data-parts="parts.json"') : file;
  };
  const server = createServer(({ url }, response) => {
    const name = new URL(url, "http://127.0.0.1").pathname.slice(1) || "index.html";
    try {
      const body = content(name);
      response.writeHead(200, { "Content-Type": TYPES[extname(name)] ?? "application/octet-stream", "Cache-Control": "no-store" }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const end = () => {
    server.close();
    server.closeAllConnections();
  };
  return { address: `http://127.0.0.1:${server.address().port}/`, end };
}
