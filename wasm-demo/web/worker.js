// A worker: draws a share of each picture, or small pictures of scenes.
import { initSync } from "./pkg/wasm_demo.js";
import { words } from "./failure.js";
import { Share, thumbnail } from "./share.js";

/** @type {Share} */
let share;
/** @type {WebAssembly.Memory} */
let memory;

/**
 * What the page can ask for.
 * @type {Record<string, (order: any) => any>}
 */
const acts = {
  hold: ({ lock }) => hold(lock),
  open({ module, share: number, count, ports }) {
    ({ memory } = initSync({ module }));
    share = new Share(number, count, ports);
  },
  equip: (order) => share.equip(order),
  draw: (order) => share.draw(order),
  loop: (order) => share.loop(order),
  compare: (order) => share.compare(order),
  /** The size of the modules' memory in bytes. */
  memory: () => memory.buffer.byteLength + share.memory,
  thumbnail({ module, ...order }) {
    initSync({ module });
    return thumbnail(order);
  },
};

/**
 * Resolves when this worker has a lock, which the browser takes from it when it ends: no event tells that. A page without
 * HTTPS has no locks.
 * @param {string} name
 */
const hold = (name) =>
  new Promise((resolve) => {
    if (!navigator.locks) return resolve(undefined);
    const held = () => (resolve(undefined), new Promise(() => {}));
    navigator.locks.request(name, held).catch(resolve);
  });

/** @type {(message: Partial<import("./workers.js").Answer>, transferred?: Transferable[]) => void} */
const tell = (message, transferred = []) => postMessage(message, { transfer: transferred });

/**
 * Answers a message. A refusal of the module is a string.
 * @param {MessageEvent} event
 */
async function answer({ data: { number, act, ...order } }) {
  try {
    const result = await acts[act](order);
    const pixels = result?.pixels ?? result;
    tell({ number, result }, ArrayBuffer.isView(pixels) ? [pixels.buffer] : []);
  } catch (error) {
    if (typeof error === "string") tell({ number, refusal: error });
    else {
      const isTrap = error instanceof WebAssembly.RuntimeError;
      tell({ number, error: words(error), isTrap });
    }
  }
}

// The message of a panic precedes its trap and is more specific.
addEventListener("luminaire-panic", (event) => tell({ panic: /** @type {CustomEvent} */ (event).detail }));
// One question at a time: a share that waits for shadow maps must not take the next picture.
let last = Promise.resolve();
addEventListener("message", (event) => {
  last = last.then(() => answer(event));
});
