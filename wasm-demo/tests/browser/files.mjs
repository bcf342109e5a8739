// A light of a file of another tool: dropped or picked, shown with its curve and its parameters, and put on the stage.
import {
  ask, assert, change, count, enter, exists, give, isDisabled, isWritten, more, must, number, open, options, press, quick, requests,
  shows, sum, until, words, works,
} from "./visit.mjs";

const ONE = "#stage?scene=bare-spot&play=none";

const COPIES = `Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => void (window.copied = text) } })`;

quick("a measured light is shown, its parameters are copied, and it lights the stage", async () => {
  await open(ONE, { script: COPIES });
  assert.deepEqual(requests.filter((name) => /file-panel|files/.test(name)), [], "files that are loaded before a file is dropped");
  await give("spot.ies");
  assert.match(await words("file-told"), /^spot\.ies: 1 light\.$/);
  assert.equal(await words("file-fit"), "Spot 12: table");
  assert.match(await words("file-residual"), /^Within 0\.\d+ of 255 codes .* at 0\.159°\.$/);
  assert.match(await words("file-photometry"), /^Peak 2,000 cd, [\d,.]+ lm, beam 10\.79°, field 29\.76°, [\d,.]+ lx at [\d.]+ m$/);
  // The points of the file up to the end of the drawing, the cone, and the largest difference.
  assert.deepEqual([await count("#file circle"), await count("#file .trace"), await count("#file .worst")], [4, 1, 1]);
  for (const tool of await options("file-tool")) {
    await enter("file-tool", tool);
    assert.match(await words("file-difference"), /^Within [\d.]+ of 255 codes over the angle/);
    await press("file-copy");
    await until(() => document.getElementById("file-copied").textContent === "Copied.");
    must(await ask(() => window.copied), (text) => text.startsWith(`# system: ${tool}\n`) && /\n\w[\w:]*=-?[\d.]+\n$/.test(text.replace("IntensityUnits=Candelas\n", "")), tool);
  }
  const before = await sum();
  await change("the light of the file", () => press("file-put"));
  assert.match(await words("file-put-note"), /^Light 1 .* has it/);
  assert.deepEqual([await number("light-intensity-number"), await number("light-beam-number")], [2000, 10.79]);
  const [address, after] = [await isWritten(/:o\w+\/0\//), await sum()];
  await change("undo", () => press("undo"));
  assert.equal(await sum(), before);
  await open(address);
  assert.equal(await sum(), after, `the light of ${address}`);
});

quick("a broken file gives the message of its reader, and the page works", async () => {
  await open(ONE);
  for (const [name, text, told] of [
    ["spot.ies", "IESNA:LM-63-1995\nTILT=NONE\n1 2", /^spot\.ies: line \d+.*expected/],
    ["a.gltf", "{", /^a\.gltf: .*expected/],
    ["picture.png", "", /^picture\.png: extension = png: expected one of gltf, .*ldt/],
  ]) {
    await give(name, text);
    assert.match(await words("file-error"), told);
    assert.deepEqual([await words("file-told"), await shows("file")], ["", false]);
    await works();
  }
  await give("spot.ies");
  assert.deepEqual([await words("file-error"), await shows("file")], ["", true]);
  await press("file-close");
  assert.ok(!(await shows("file")));
});

quick("lights of a scene are chosen, and the page reads its own JSON", async () => {
  await open(ONE);
  await give("three.gltf");
  assert.deepEqual([await words("file-told"), (await options("file-light")).length], ["three.gltf: 3 lights.", 3]);
  await enter("file-light", "1");
  assert.deepEqual([await shows("file-curve"), await isDisabled("file-put")], [false, true]);
  await give("three.json");
  assert.deepEqual([await words("file-fit"), await words("file-residual")], ["spot", "Exact."]);
  await change("the light of three.js", () => press("file-put"));
  assert.equal(await ask(() => document.getElementById("light-color").value), "#ff8000");
  const [after, intensity] = [await sum(), await number("light-intensity-number")];
  await ask(() => document.querySelector("#code summary").click());
  await exists("#code-text:not(:empty)");
  await enter("code-language", "json");
  const text = await ask(() => document.getElementById("code-text").textContent);
  await change("another cone", () => enter("light-field", 0.7));
  await give("light.json", text);
  await change("the light before", () => press("file-put"));
  assert.deepEqual([await sum(), await number("light-intensity-number")], [after, intensity]);
});

more("a button opens the choice of a file, and a file that hovers is expected", async () => {
  await open(ONE);
  await ask(() => document.getElementById("file-input").addEventListener("click", (event) => (event.preventDefault(), (window.opened = true))));
  await press("file-pick");
  assert.ok(await ask(() => window.opened));
  const hovers = (type) => ask((type) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([""], "a.ies"));
    const isLeft = document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    return [isLeft, document.body.classList.contains("dropping")];
  }, type);
  assert.deepEqual([await hovers("dragover"), await hovers("dragleave")], [[false, true], [false, false]]);
});
