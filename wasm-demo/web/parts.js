// The parts of the demo that its server is still building: `cargo demo` serves the page as soon as the
// stage is built, with the address of a list of all parts. A page that is built whole has no list, and
// nothing waits.

/**
 * A part of the list, and why it has failed.
 * @typedef {{ name: string, state: "built" | "building" | "waiting" | "failed", reason?: string }} Part
 */

/** Time between two requests of the list, in milliseconds. */
const PAUSE = 1000;

/** Requests without an answer after which the server is taken to have ended. */
const TRIES = 4;

const OPENS = "It opens by itself.";

/** What each part is to a visitor, and what follows once it is built. */
const WORDS = {
  wide: ["The 32-bit renderer", "Until then the picture is drawn in 16 bits."],
  price: ["The price", OPENS],
  code: ["The code exporter", OPENS],
  comparison: ["The comparison with f64", OPENS],
  class: ["The class", OPENS],
  files: ["The file reader", "It reads the file by itself."],
  chip: ["The chip", OPENS],
};

/** @typedef {keyof typeof WORDS} Name of a part that the page waits for */

/** The names of the parts that were waited for and are built. */
const ready = new Set();

/**
 * Who waits for a part.
 * @type {Set<{ name: Name, tell: (text: string) => void, resolve: (value?: undefined) => void, reject: (error: Error) => void }>}
 */
const waiting = new Set();
let isLooking = false;
/** Ends the pause before the next request. */
let wake = () => {};

/**
 * Whether a part is known to be built.
 * @param {Name} name
 */
export const isBuilt = (name) => document.body.dataset.parts === undefined || ready.has(name);

/**
 * Resolves when a part is built. Rejects if it could not be built, or if the server does not answer;
 * the next call asks again.
 * @param {Name} name
 * @param {(text: string) => void} [tell] called with what is being built, in words, until it is
 */
export async function built(name, tell = () => {}) {
  if (isBuilt(name)) return;
  await new Promise((resolve, reject) => {
    waiting.add({ name, tell, resolve, reject });
    if (isLooking) wake();
    else look();
  });
}

/** Resolves after a while, or when somebody else begins to wait. */
const pause = () =>
  new Promise((resolve) => {
    wake = () => resolve(undefined);
    setTimeout(resolve, PAUSE);
  });

/** Requests the list at once and after each pause, while somebody waits. */
async function look() {
  isLooking = true;
  let failed = 0;
  while (waiting.size > 0) {
    const parts = await request().catch(() => undefined);
    failed = parts ? 0 : failed + 1;
    if (parts) judge(parts);
    else if (failed === TRIES) {
      for (const { reject } of waiting) reject(new Error("The server of the demo does not answer. Run `cargo demo` again."));
      waiting.clear();
    }
    if (waiting.size > 0) await pause();
  }
  isLooking = false;
}

/** @returns {Promise<Part[]>} */
async function request() {
  const answer = await fetch(document.body.dataset.parts ?? "");
  // A server that has no list has nothing left to build.
  return answer.status === 404 ? [] : (await answer.json()).parts;
}

/**
 * Answers those whose part is built or has failed, and tells the others how far the build is.
 * @param {Part[]} parts
 */
function judge(parts) {
  const count = parts.filter(({ state }) => state === "built").length;
  for (const one of waiting) {
    const { state, reason = "" } = parts.find(({ name }) => name === one.name) ?? { state: "built" };
    const [what, then] = WORDS[one.name];
    if (state === "building" || state === "waiting") {
      const begun = state === "building" ? "is being built" : "is not built yet";
      one.tell(`${what} ${begun}: ${count} of ${parts.length} parts ${count === 1 ? "is" : "are"} ready. ${then}`);
      continue;
    }
    waiting.delete(one);
    if (state === "failed") one.reject(new Error(`${what} could not be built: ${reason.replace(/[.\s]*$/, ".")} Run \`cargo demo\` again once that is mended.`));
    else {
      ready.add(one.name);
      one.resolve();
    }
  }
}
