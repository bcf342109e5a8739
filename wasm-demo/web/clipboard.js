// Copying of text.

/**
 * Copies the text of an element, or selects it where the browser copies nothing. Returns in words
 * what has happened.
 * @param {Element} source
 */
export async function copyTextOf(source) {
  try {
    await navigator.clipboard.writeText(source.textContent ?? "");
    return "Copied.";
  } catch {
    getSelection()?.selectAllChildren(source);
    return "The browser copies nothing here. The text is selected: copy it with Ctrl+C or ⌘C.";
  }
}
