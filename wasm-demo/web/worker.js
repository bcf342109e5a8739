// A worker: draws a share of each picture, or small pictures of scenes.
import { initSync } from "./pkg/wasm_demo.js";
import { Share, thumbnail } from "./share.js";

let share;
let memory;

const acts = {
  open({ module, share: number, count, ports }) {
    ({ memory } = initSync({ module }));
    share = new Share(number, count, ports);
  },
  draw: (order) => share.draw(order),
  loop: (order) => share.loop(order),
  compare: (order) => share.compare(order),
  /** The size of the module's memory in bytes. */
  memory: () => memory.buffer.byteLength,
  thumbnail({ module, ...order }) {
    initSync({ module });
    return thumbnail(order);
  },
};

/** Answers a message. A refusal of the module is a string. */
async function answer({ data: { number, act, ...order } }) {
  try {
    const result = await acts[act](order);
    const pixels = result?.pixels ?? result;
    postMessage({ number, result }, ArrayBuffer.isView(pixels) ? [pixels.buffer] : []);
  } catch (error) {
    if (typeof error === "string") postMessage({ number, refusal: error });
    else {
      const isTrap = error instanceof WebAssembly.RuntimeError;
      postMessage({ number, error: String(error?.message ?? error), isTrap });
    }
  }
}

// The message of a panic precedes its trap and is more specific.
addEventListener("luminaire-panic", (event) => postMessage({ panic: event.detail }));
addEventListener("message", answer);
