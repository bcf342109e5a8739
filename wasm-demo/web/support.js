// Requirements on the browser, and parameters of the page's address.
import { words } from "./failure.js";

/** The smallest module with a SIMD instruction: a function that splats a byte and counts its bits. */
const SIMD = Uint8Array.of(
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
);

/** Most workers that an address can ask for. */
const MOST_WORKERS = 16;

/** Throws if the module can't be compiled: it uses WebAssembly's 128-bit SIMD. */
export function requireSimd() {
  if (typeof WebAssembly !== "object" || !WebAssembly.validate(SIMD)) {
    throw new Error(
      "This browser has no WebAssembly SIMD, which the demo is compiled for. " +
        "Use Chrome or Edge 91, Firefox 89, Safari 16.4, or anything newer.",
    );
  }
}

/**
 * The number of failed imports of each file.
 * @type {Map<string, number>}
 */
const failures = new Map();

/**
 * Imports a file of the page. The browser caches a failed import by its address, so that every
 * retry uses a new address.
 * @param {string} file
 */
export async function load(file) {
  const failed = failures.get(file) ?? 0;
  try {
    return await import(`./${file}${failed === 0 ? "" : `?attempt=${failed}`}`);
  } catch (error) {
    failures.set(file, failed + 1);
    throw new Error(
      `${file}, or a file that it needs, could not be loaded (${words(error)}). ` +
        "Is the connection up, and the whole folder served?",
      { cause: error },
    );
  }
}

/**
 * The size of the picture and the number of workers, `?width=&height=&workers=`, else undefined; with
 * `?rest=0` that pictures at rest have the size of those that move; and in words what was refused. The
 * module checks the range of a size.
 * @param {string} search
 */
export function requested(search) {
  const query = new URLSearchParams(search);
  /** @type {string[]} */
  const refused = [];
  /** @type {(name: string, most: number, expected: string) => number | undefined} */
  const count = (name, most, expected) => {
    const text = query.get(name);
    if (text === null) return undefined;
    if (/^\d{1,9}$/.test(text) && Number(text) <= most) return Number(text);
    refused.push(`${name} = "${text}": expected ${expected}`);
    return undefined;
  };
  const [width, height] = ["width", "height"].map((name) => count(name, Infinity, "a whole number of pixels"));
  const workers = count("workers", MOST_WORKERS, `0 to ${MOST_WORKERS} workers`);
  return { width, height, workers, rests: query.get("rest") !== "0", refused };
}
