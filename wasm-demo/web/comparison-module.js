// The module of the comparison and the museum, started when one of the two is first requested.
import { initSync } from "./pkg/comparison.js";
import { compile } from "./module.js";

/** Starts the module. Later calls change nothing. */
export async function start() {
  initSync({ module: await compile(new URL("pkg/comparison_bg.wasm", import.meta.url)) });
}
