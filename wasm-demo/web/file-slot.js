// The lights of files, and maps of LEDs, that are picked by a button or dropped on the page: one file is shown, and a list has the
// others. What reads them is loaded with the first one.
import { element } from "./elements.js";
import { words } from "./failure.js";
import { built } from "./parts.js";
import { load } from "./support.js";
import { reveal } from "./tabs.js";

/** @param {import("./file-panel.js").OnStage} stage */
export function takeFiles(stage) {
  const [place, told, input] = [element("file"), element("file-told"), element("file-input", HTMLInputElement)];
  // Of a light whose planes differ.
  const round = element("file-round");
  /** @type {ReturnType<typeof import("./file-panel.js").openPanel> | undefined} */
  let panel;
  const which = element("file-which", HTMLSelectElement);
  /** @type {File[]} */
  let files = [];
  /** @type {File | undefined} */
  let newest;

  /** Loads the panel for the first file, and again after a failure. */
  async function opened() {
    const { openPanel } = await load("file-panel.js");
    const opening = (panel ??= openPanel(place, stage));
    opening.catch(() => (panel = undefined));
    return opening;
  }

  /** @type {(file: File | undefined, isRound?: boolean) => Promise<void>} */
  async function open(file, isRound = false) {
    if (!file) return;
    newest = file;
    if (element("stage-page").hidden) location.hash = "stage";
    reveal(told);
    [told.textContent, told.className] = [`Reading ${file.name}.`, "note"];
    round.hidden = true;
    try {
      if (file.size > 2 ** 26) throw `size = ${file.size}: expected at most ${2 ** 26} bytes`;
      await built("files", (text) => (told.textContent = text));
      const [bytes, show] = await Promise.all([file.arrayBuffer(), opened()]);
      if (file !== newest) return;
      const shown = await show(file.name, new Uint8Array(bytes), isRound);
      [told.textContent, round.hidden] = [shown.told, shown.isRound];
    } catch (error) {
      if (file !== newest) return;
      [told.textContent, told.className] = [`${file.name}: ${words(error)}`, "error"];
      place.hidden = true;
    }
    told.scrollIntoView({ block: "nearest" });
  }

  /** @param {FileList | null} found */
  function take(found) {
    // A picker that is closed without a choice leaves the files as they are.
    if (!found?.length) return;
    files = [...found];
    which.replaceChildren(...files.map(({ name }, i) => new Option(`${i + 1} of ${files.length}: ${name}`, String(i))));
    element("file-files").hidden = files.length === 1;
    open(files[0]);
  }

  which.addEventListener("input", () => open(files[which.selectedIndex]));
  round.addEventListener("click", () => open(newest, true));
  element("file-pick").addEventListener("click", () => input.click());
  input.addEventListener("change", () => take(input.files));
  for (const type of /** @type {const} */ (["dragover", "dragleave", "drop"])) {
    document.addEventListener(type, (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      // Else the browser would show the file in place of the page.
      event.preventDefault();
      document.body.classList.toggle("dropping", type === "dragover");
      if (type === "drop") take(event.dataTransfer.files);
    });
  }
}
