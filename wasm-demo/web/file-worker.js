// Reads files of other tools off the page's thread, which a large file would hold up.
import { words } from "./failure.js";
import { compile } from "./module.js";
import { LedFile, LightFile, initSync } from "./pkg/files.js";

const ready = compile(new URL("pkg/files_bg.wasm", import.meta.url)).then((module) => initSync({ module }));

/** @type {LightFile | undefined} */
let file;
/** What has panicked: the message precedes its trap, and is more specific. */
let panic = "";
addEventListener("luminaire-panic", (event) => (panic = /** @type {CustomEvent} */ (event).detail));

onmessage = async ({ data: { number, question } }) => {
  try {
    await ready;
    postMessage({ number, answer: answerTo(question) });
  } catch (refusal) {
    // The module refuses with a string.
    postMessage(typeof refusal === "string" ? { number, refusal } : { number, failure: panic || words(refusal) });
  }
};

/** @param {import("./file-thread.js").Question} question about a new file, or about the last one */
function answerTo(question) {
  if ("bytes" in question) {
    file?.free();
    file = undefined;
    const leds = LedFile.read(question.name, question.bytes);
    if (leds) return { places: leds.places, facing: leds.facing, told: leds.told };
    file = new LightFile(question.name, question.bytes, question.reach, question.isRound);
    return JSON.parse(file.told());
  }
  if (!file) throw "file = none: expected a file that has been read. Open it again.";
  const { light, tool } = question;
  return tool === undefined ? { room: file.picture(light, true), sphere: file.picture(light, false) } : file.parameters(light, tool);
}
