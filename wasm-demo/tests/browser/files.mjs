// A light of a file of another tool: dropped, shown with its curve and its parameters, and put on the stage.
import { readFileSync } from "node:fs";

import {
  ask, assert, change, count, enter, exists, give, isDisabled, isWritten, must, number, open, press, quick, requests, shows, sum,
  until, value, words, works,
} from "./visit.mjs";

const ONE = "#stage?scene=bare-spot&play=none";

quick("a measured light is shown, its parameters are copied, and it lights the stage", async () => {
  const script = `Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => void (window.copied = text) } })`;
  await open(ONE, { script });
  assert.deepEqual(requests.filter((name) => /file-(panel|thread|worker)|files/.test(name)), [], "files that are loaded before a file is dropped");
  await give("spot.ies");
  assert.deepEqual([await words("file-told"), await words("file-fit")], ["spot.ies: 1 light.", "Spot 12: table"]);
  assert.match(await words("file-difference"), /^Within 0\.\d+ of 255 codes .* found 0\.40 at 0\.16°\.$/);
  assert.match(await words("file-photometry"), /^Peak 2,000 cd, 140 lm, beam 10\.79°, field 29\.76°, [\d.]+ lx at [\d.]+ m$/);
  assert.deepEqual([await count("#file .dot"), await count("#file .trace"), await count("#file .drop")], [4, 1, 2]);
  await enter("file-tool", "godot");
  await until(() => document.getElementById("file-parameters").textContent.startsWith("# system: godot"));
  assert.match(await words("file-parameters-told"), /^Within [\d.]+ of 255 codes over the angle/);
  await press("file-copy");
  await until(() => document.getElementById("file-copied").textContent === "Copied.");
  assert.match(await ask(() => window.copied), /^# system: godot\n# name: Spot 12\n# kind: spot\n(# \w+: [-\d.,]+\n)+spot_angle=[\d.]+\n(\w+=[\d.]+\n)+$/);
  const before = await sum();
  await change("the light of the file", () => press("file-put"));
  assert.deepEqual([await number("light-intensity-number"), await number("light-beam-number")], [2000, 10.79]);
  // It has its name, and is in the picture at full scale.
  assert.deepEqual([await words("panel-title"), await ask(() => document.querySelector("#lights .name").textContent)], ["1 Spot-12", "1 Spot-12"]);
  assert.match(await words("file-put-told"), /^It is light 1 Spot-12, here and in the link\. The picture is exposed for it, by -?[\d.]+ EV\.$/);
  must(Number((await words("light-photometry")).match(/([\d.]+) times full scale/)[1]), (shown) => shown > 0.85 && shown < 1.15, "a light at full scale");
  const [address, after] = [await isWritten(/:oknots\/0\//), await sum()];
  await change("a narrower beam", () => enter("light-beam-number", 5));
  for (let step = 0; step < 2; step += 1) await change("undo", () => press("undo"));
  assert.equal(await sum(), before);
  await open(address);
  assert.equal(await sum(), after, `the light of ${address}`);
});

quick("a broken file gives the message of its reader, and the page works", async () => {
  await open(ONE);
  for (const [name, text, told] of [
    ["spot.ies", "IESNA:LM-63-1995\nTILT=NONE\n1 2", /^spot\.ies: line \d+.*expected/],
    ["picture.png", "", /^picture\.png: extension = png: expected one of babylon, .*ldt/],
  ]) {
    await give(name, text);
    assert.match(await words("file-told"), told);
    await works();
  }
  await give("spot.ies");
  assert.ok(await shows("file"));
});

quick("a light that is not round lights a room, and the mean of its planes the stage", async () => {
  await open(ONE);
  await give("uneven.ies", "IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 3 2 1 2 0 0 0\n1 1 1\n0 10 20\n0 180\n1000 500 0\n1000 900 0\n");
  assert.equal(await words("file-told"), "uneven.ies: 1 light.");
  assert.match(await words("file-photometry"), /^Peak 1,000 cd, [\d.]+ lm, .*\nthe light is not round: a table of \d+ x \d+ samples/);
  assert.deepEqual([await shows("file-uneven"), await shows("file-tools"), await shows("file-round"), await isDisabled("file-put")], [true, false, true, true]);
  assert.deepEqual([await count("#file .trace"), await count("#file .other")], [1, 1]);
  await until(() => document.getElementById("file-sphere").getContext("2d").getImageData(110, 110, 1, 1).data[3] > 0);
  const [left, right] = await ask(() => {
    const { data } = document.getElementById("file-sphere").getContext("2d").getImageData(0, 110, 220, 1);
    const sums = [0, 0];
    for (let x = 0; x < 220; x += 1) sums[x < 110 ? 0 : 1] += data[4 * x];
    return sums;
  });
  must([left, right], ([left, right]) => left > 1.1 * right, "more light at the side of plane 180");
  assert.ok(await ask(() => new Set(document.getElementById("file-room").getContext("2d").getImageData(0, 0, 440, 240).data).size) > 100);
  await press("file-round");
  await until(() => document.getElementById("file-told").textContent === "uneven.ies: 1 light.");
  assert.deepEqual([await shows("file"), await shows("file-uneven"), await isDisabled("file-put")], [true, false, false]);
  assert.match(await words("file-difference"), /, and 51\.\d+ of each plane;/);
  assert.match(await words("file-notes"), /^The light is taken as round: /);
});

quick("a wide light with a colour temperature goes on the stage", async () => {
  await open(ONE);
  const wide = ["Maker", "1", "1", "1", "0", "2", "0", "R", "Wide", "", "wide.ldt", "", ...Array(9).fill("0"), "100", "100", "1", "0", "1",
    "1", "LED", "500", "830", "90", "12", ...Array(10).fill("0.5"), "0", "0", "90", "4000", "200"];
  await give("wide.ldt", `${wide.join("\n")}\n`);
  assert.match(await words("file-photometry"), /^Peak 2,000 cd, .*, 3000 K/);
  assert.match(await words("file-notes"), /taken as 3000 K/);
  assert.match(await words("file-put-told"), /, and at 80° off its axis, as far as shadows reach\.$/);
  const before = await sum();
  await change("the light of the file", () => press("file-put"));
  assert.deepEqual([await number("light-intensity-number"), await number("light-kelvin-number")], [2000, 3000]);
  const [address, after] = [await isWritten(/:w3000/), await sum()];
  await open(address);
  assert.equal(await sum(), after);
  assert.notEqual(before, after);
});

quick("several files that are dropped become a list", async () => {
  await open(ONE);
  const text = readFileSync(new URL("../../../exchange/tests/files/spot.ies", import.meta.url), "utf8");
  await ask((text) => {
    const dataTransfer = new DataTransfer();
    for (const [name, content] of [["spot.ies", text], ["broken.ies", "TILT=NONE"], ["again.ies", text]]) dataTransfer.items.add(new File([content], name));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, text);
  const told = (start) => until((start) => document.getElementById("file-told").textContent.startsWith(start), start);
  await told("spot.ies: 1 light.");
  const listed = await ask(() => Array.from(document.getElementById("file-which").options, ({ textContent }) => textContent));
  assert.deepEqual([await shows("file-which"), listed], [true, ["1 of 3: spot.ies", "2 of 3: broken.ies", "3 of 3: again.ies"]]);
  for (const [place, words, isRead] of [[1, "broken.ies: line", false], [2, "again.ies: 1 light.", true]]) {
    await enter("file-which", place);
    await told(words);
    assert.equal(await shows("file"), isRead);
  }
  await give("spot.ies");
  assert.equal(await shows("file-which"), false, "a list of one file");
});

/** A photometric file that takes a while. */
function longFile() {
  const places = Array.from({ length: 60_000 }, (_, i) => i / 1000);
  return `IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 60000 1 1 2 0 0 0\n1 1 1\n${places.join("\n")}\n0\n${places.map(() => 1).join("\n")}`;
}

quick("of two files that are dropped at once the last is shown, although the first one takes longer", async () => {
  await open(ONE);
  await give("spot.ies");
  await ask((long) => {
    for (const [name, text] of [["long.ies", long], ["empty.ies", ""]]) {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, longFile());
  await until(() => document.getElementById("file-told").textContent.startsWith("empty.ies: "));
  await give("three.gltf");
  assert.match(await words("file-told"), /^three\.gltf: \d+ lights\.$/);
});

quick("lights of a scene are chosen, and the page reads its own JSON", async () => {
  await open(ONE);
  await give("three.gltf");
  await enter("file-light", 1);
  assert.deepEqual([await shows("file-curve"), await isDisabled("file-put")], [false, true]);
  await give("three.json");
  assert.match(await words("file-difference"), /^Within 0\.00 of 255 codes/);
  await change("the light of three.js", () => press("file-put"));
  const state = async () => [await sum(), await number("light-intensity-number"), await value("light-color")];
  const after = await state();
  await ask(() => document.querySelector("#code summary").click());
  await exists("#code-text:not(:empty)");
  await enter("code-language", "json");
  const text = await ask(() => document.getElementById("code-text").textContent);
  await change("another cone", () => enter("light-field", 0.7));
  await give("light.json", text);
  await change("the light before", () => press("file-put"));
  assert.deepEqual([after[2], await state()], ["#ff8000", after]);
});

quick("a file is read to its end although the tool for the file before it is changed", async () => {
  await open(ONE);
  const told = await ask(async (long) => {
    const { FileThread } = await import(new URL("file-thread.js", location.href).href);
    const thread = new FileThread();
    const file = () => thread.ask({ name: "long.ies", bytes: new TextEncoder().encode(long), reach: 6 });
    const none = await thread.ask({ light: 0, tool: "godot" }).catch((refusal) => refusal);
    const read = file();
    thread.ask({ light: 0, tool: "godot" });
    const { lights } = await read;
    return [none, lights.length, (await thread.ask({ light: 0, tool: "godot" }))[0].split("\n")[0]];
  }, longFile());
  assert.deepEqual(told, ["file = none: expected a file that has been read. Open it again.", 1, "# system: godot"]);
});

quick("a map of LEDs takes the place of those of the tree, and can be undone", async () => {
  await open(ONE);
  await give("tree.csv", `index,x,y,z,xn,yn,zn\n${Array.from({ length: 90 }, (_, i) => `${i},${Math.cos(i)},${Math.sin(i)},${i / 30},${Math.cos(i)},${Math.sin(i)},0`).join("\n")}`);
  assert.equal(await words("file-told"), "tree.csv: 90 LEDs, 2 m high: each takes the light of the side that it faces, as the map says. They are on the tree's stage, but not in the link.");
  await until(() => /^90 LEDs take/.test(document.getElementById("leds").textContent));
  await isWritten(/scene=tree/);
  assert.equal(await shows("file"), false);
  const before = await sum();
  await give("flat.json", JSON.stringify(Array.from({ length: 64 }, (_, i) => [i % 8, i >> 3])));
  await until(() => /^64 LEDs take/.test(document.getElementById("leds").textContent));
  assert.match(await words("file-told"), /^flat\.json: 64 LEDs, 2 m high: each takes the light of the side away from/);
  await change("the LEDs before", () => press("undo"));
  assert.equal(await sum(), before);
  for (const [name, content, refusal] of [
    ["two.csv", "0,0,0\n1,0,0", /^two\.csv: LEDs = 2 at one height: expected at least two heights/],
    ["gap.csv", "index,x,y,z\n0,1,2,3\n2,1,2,4", /^gap\.csv: LED = 2: expected 1/],
    ["many.csv", Array.from({ length: 2001 }, (_, i) => `0,0,${i}`).join("\n"), /^many\.csv: LEDs = 2001: expected 1 to 2000 on the page/],
  ]) {
    await give(name, content);
    assert.match(await words("file-told"), refusal);
    assert.equal(await sum(), before, `${name} changes nothing`);
  }
});
