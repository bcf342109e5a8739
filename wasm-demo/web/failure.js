// Shows failures on the page as well as on the console. Only a failure of the module stops the
// demo.
import { element, find } from "./elements.js";

let failed = false;

/** Whether the demo has stopped for good. */
export const hasFailed = () => failed;

/**
 * Stops the demo and tells the visitor why, once: what follows a failure is its consequence.
 * @param {unknown} cause an Error, or a string of the module's
 */
export function fail(cause) {
  if (failed) return;
  failed = true;
  tell("failure", words(cause));
  find(document, "main").inert = true;
  document.body.dataset.state = "failed";
}

/**
 * Tells the visitor what the page does without.
 * @param {string} text
 */
export const notice = (text) => tell("trouble", text);

/**
 * Does something that no picture depends on. A failure is reported, and the rest continues.
 * @param {() => void} act
 */
export function aside(act) {
  try {
    act();
  } catch (error) {
    reportError(error);
  }
}

/**
 * Acts, and returns what the module refuses, in words; else nothing. Its refusals are strings, and
 * anything else is a bug in the page.
 * @param {() => void} act
 */
export function refusalOf(act) {
  try {
    act();
  } catch (refusal) {
    if (typeof refusal !== "string") throw refusal;
    // What is typed and cannot be read.
    return refusal.replace(" = NaN:", " is no number:");
  }
  return "";
}

/**
 * Returns the message of an error, or of another thrown value.
 * @param {unknown} cause
 */
export const words = (cause) => (cause instanceof Error ? cause.message : String(cause));

/**
 * Ends a text as a sentence ends.
 * @param {string} text
 */
export const sentence = (text) => (/[.?!]$/.test(text) ? text : `${text}.`);

/**
 * Returns whether an error is a trap of the module, after which it can't be called any more.
 * @param {unknown} cause
 */
export const isTrap = (cause) => /** @type {any} */ (cause)?.name === "RuntimeError";

/**
 * Installs handlers: panics and traps of the module stop the demo, and uncaught errors are shown.
 */
export function watch() {
  /** @type {(what: unknown) => void} */
  const broken = (what) => fail(`The demo has stopped: ${sentence(String(what))} Reload the page to start again.`);
  /** @type {(cause: unknown) => void} */
  const judge = (cause) =>
    isTrap(cause) ? broken(cause) : tell("trouble", `A part of this page has failed: ${sentence(String(cause))} The rest still works.`);
  // The message of a panic precedes its trap and is more specific.
  window.addEventListener("luminaire-panic", (event) => broken(/** @type {CustomEvent} */ (event).detail));
  window.addEventListener("error", (event) => judge(event.error ?? event.message));
  window.addEventListener("unhandledrejection", (event) => judge(event.reason));
}

/** @type {(id: string, text: string) => void} */
function tell(id, text) {
  const place = element(id);
  place.textContent = text;
  place.hidden = false;
}
