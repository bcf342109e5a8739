// Copying of text.

/**
 * Copies the text of an element, or selects it where the browser copies nothing.
 * @param {Element} source
 * @param {Element} told where what has happened is said in words
 */
export async function copyTextOf(source, told) {
  try {
    await navigator.clipboard.writeText(source.textContent ?? "");
    told.textContent = "Copied.";
  } catch {
    getSelection()?.selectAllChildren(source);
    told.textContent = "The browser copies nothing here. The text is selected: copy it with Ctrl+C or ⌘C.";
  }
}
