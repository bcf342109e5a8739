// What fails is told on the page, not only on the console: the module's end stops the demo, anything else does not.

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
  document.querySelector("main").inert = true;
  document.body.dataset.state = "failed";
}

/** Does something that no picture depends on. If it fails, that is told, and all else goes on. */
export function aside(act) {
  try {
    act();
  } catch (error) {
    reportError(error);
  }
}

/** An error, or what else was thrown, in words. */
export const words = (cause) => (cause instanceof Error ? cause.message : String(cause));

/** Whether an error is a trap of the module, which no call to it works after. */
export const isTrap = (cause) => cause?.name === "RuntimeError";

/** From here on panics and traps of the module stop the demo, and errors that nobody catches are told. */
export function watch() {
  const broken = (what) => fail(`The demo has stopped: ${what}. Reload the page to start again.`);
  const judge = (cause) =>
    isTrap(cause) ? broken(cause) : tell("trouble", `A part of this page has failed: ${cause}. The rest still works.`);
  // The panic's own message comes first, and says more than the trap that follows it.
  window.addEventListener("luminaire-panic", (event) => broken(event.detail));
  window.addEventListener("error", (event) => judge(event.error ?? event.message));
  window.addEventListener("unhandledrejection", (event) => judge(event.reason));
}

function tell(id, text) {
  const place = document.getElementById(id);
  place.textContent = text;
  place.hidden = false;
}
