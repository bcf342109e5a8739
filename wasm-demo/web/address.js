// The address follows the view, so that it can be shared.

/**
 * Delay between the last change and the update, in milliseconds: Safari rejects more than 100
 * updates within ten seconds.
 */
const REST = 250;

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
    // A failed update leaves the address out of date, which harms nothing else.
    console.info(`The address was not written: ${error}`);
  }
}
