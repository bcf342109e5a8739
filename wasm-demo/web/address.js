// The address follows what is shown, so that it can be passed on.

/** It is written so long after the last change, in milliseconds: Safari refuses the 101st time within ten seconds. */
const REST = 250;

let current;
let waiting;

/** From now on the address is that of another view; what was to be written of the one before is out of date. */
export function follow(view) {
  current = view;
  clearTimeout(waiting);
}

/** Has the address say behind its # what a view shows, once the visitor has paused; others than the current one wait. */
export function remember(view, query) {
  if (view !== current) return;
  clearTimeout(waiting);
  waiting = setTimeout(() => write(`#${view}?${query}`), REST);
}

function write(hash) {
  try {
    history.replaceState(null, "", hash);
  } catch (error) {
    // The address is behind then, which harms nothing that is shown.
    console.info(`The address was not written: ${error}`);
  }
}
