// The painters of pictures in fixed point: a module of their own, started with the first such picture.
import { initSync, Painter } from "./pkg/fixed_point.js";

/**
 * Starts the module. Returns the class of its painters, and its memory.
 * @param {WebAssembly.Module} module
 */
export function start(module) {
  const { memory } = initSync({ module });
  return { Painter, memory };
}
