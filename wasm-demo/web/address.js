// The address follows the view, so that it can be shared.

/**
 * Delay between the last change and the update, in milliseconds: Safari rejects more than 100
 * updates within ten seconds.
 */
const REST = 250;

/** Delay after which a rejected update is tried again, in milliseconds. */
const AGAIN = 10_000;

/** What an address may hold that is not written as it is: escapes of URLs, of HTML and of mail. */
const ESCAPES = /((?:%[\da-f]{2})+)|&#(\d{1,6});|&#x([\da-f]{1,5});|&(amp);|=(3D)/gi;

/** @type {(whole: string, ...escapes: (string | undefined)[]) => string} */
function unescape(whole, url, decimal, hexadecimal, ampersand) {
  try {
    if (url) return decodeURIComponent(url);
  } catch {
    return whole;
  }
  if (decimal || hexadecimal) return String.fromCodePoint(decimal ? Number(decimal) : parseInt(hexadecimal ?? "", 16));
  return ampersand ? "&" : "=";
}

/**
 * Splits the part of an address after its #: the name of a view, and the text of its state. Programs that pass an address on escape
 * it, also twice, break its lines, close it by the punctuation of a sentence and add parameters. All of this can be undone, because
 * the page writes nothing but letters, digits and `-_.:/&=`, and none of the signs but `=` at the end.
 * @param {string} hash
 */
export function requestedView(hash) {
  let text = hash;
  for (let before; before !== text; ) [before, text] = [text, text.replace(ESCAPES, unescape)];
  // Spaces, invisible signs, and dashes that were a hyphen.
  text = text.replace(/[\s\p{Cf}]/gu, "").replace(/[\p{Pd}\u2212]/gu, "-");
  const [name = "", ...query] = text.replace(/^#/, "").replace(/[^a-z\d=]+$/i, "").split(/[?#&]+/);
  return { name, query: query.join("&") };
}

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
