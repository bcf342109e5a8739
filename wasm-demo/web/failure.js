// What can't be gone on from is told on the page, not only on the console.

let failed = false;

/** Whether something has gone wrong for good. */
export const hasFailed = () => failed;

/**
 * Tells the visitor, once: what follows a failure is its consequence.
 * @param {unknown} cause an Error, or a string of the module's
 */
export function fail(cause) {
  if (failed) return;
  failed = true;
  const place = document.getElementById("failure");
  place.textContent = cause instanceof Error ? cause.message : String(cause);
  place.hidden = false;
  document.querySelector("main").inert = true;
  document.body.dataset.state = "failed";
}

/** From here on panics of the module and exceptions that nobody catches are failures. */
export function watch() {
  const broken = (what) => fail(`The demo has stopped: ${what} Reload the page to start again.`);
  // The panic's own message comes first, and says more than the trap that follows it.
  window.addEventListener("luminaire-panic", (event) => broken(`${event.detail}.`));
  window.addEventListener("error", (event) => broken(`${event.message}.`));
  window.addEventListener("unhandledrejection", (event) => broken(`${event.reason}.`));
}
