// The address follows the view, so that it can be shared.

/**
 * Delay between the last change and the update, in milliseconds: Safari rejects more than 100
 * updates within ten seconds.
 */
const REST = 250;

/** Delay after which a rejected update is tried again, in milliseconds. */
const AGAIN = 10_000;

/** @type {string | undefined} */
let current;
/** @type {number | undefined} */
let waiting;

/**
 * Switches to the address of another view and drops a pending update of the previous one.
 * @param {string} view
 */
export function follow(view) {
  current = view;
  clearTimeout(waiting);
}

/**
 * Writes the state of a view behind the # once the visitor has paused, when `state()` returns it as
 * text. Only the current view may write.
 * @param {string} view
 * @param {() => string} state
 */
export function remember(view, state) {
  if (view !== current) return;
  clearTimeout(waiting);
  waiting = setTimeout(() => write(`#${view}?${state()}`), REST);
}

/** @param {string} hash */
function write(hash) {
  try {
    history.replaceState(null, "", hash);
  } catch (error) {
    // Until the next attempt the address is out of date, which harms nothing else.
    waiting = setTimeout(() => write(hash), AGAIN);
    console.info(`The address was not written: ${error}`);
  }
}
