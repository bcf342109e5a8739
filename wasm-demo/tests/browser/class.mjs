// The class: every figure opens, its controls change the picture, and its link restores them.
import {
  ask, assert, enter, follow, isOpen, isWritten, more, must, open, press, quick, redraw, requests, settle, shows, value, words,
} from "./visit.mjs";

const told = () => ask(() => window.luminaire.class.state);
/** A sum of the pictures: two hardly ever have the same. */
const sum = () =>
  ask(() => {
    const codes = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    const canvases = [...document.querySelectorAll("#class-pictures canvas")];
    return canvases.flatMap((canvas) => [...codes(canvas)]).reduce((sum, code) => (31 * sum + code) % 4294967291, 7);
  });

quick("every figure of the class opens, its controls change it, and its link restores it", async () => {
  await open();
  assert.deepEqual(requests.filter((name) => /class/.test(name)), [], "files that are loaded before the class is opened");
  await follow("class");
  await isOpen("class");
  const names = await ask(() => Array.from(document.querySelectorAll("#class-list a"), ({ hash }) => hash.replace("#class?figure=", "")));
  assert.equal(names.length, 13);
  for (const [place, name] of names.entries()) {
    assert.equal((await told()).figure, name);
    assert.equal(await ask(() => document.querySelectorAll("#class-list [aria-current]").length), 1);
    assert.ok(await ask(() => [...document.querySelectorAll("#class-pictures canvas")].every((canvas) => canvas.ariaLabel)), name);
    for (const [id, shown] of [["choice", "select"], ["dial-0", "value-0"], ["dial-1", "value-1"]]) {
      if (!(await shows(`class-${id}`))) continue;
      const before = [await sum(), (await told()).address];
      const other = await ask((id) => (({ min, max, options }) => options?.[1].value ?? Number(min) + 0.3 * (Number(max) - Number(min)))(document.getElementById(id)), `class-${shown}`);
      await (shown === "select" ? enter("class-select", other) : redraw(`${name}, ${shown}`, () => enter(`class-${shown}`, other)));
      const after = [await sum(), (await told()).address];
      assert.notEqual(after[1], before[1], `the address of ${name}, ${shown}`);
      if (!after[1].includes("which=") || shown !== "select") assert.notEqual(after[0], before[0], `the picture of ${name}, ${shown}`);
    }
    assert.equal(await shows("class-answer"), false);
    await ask(() => document.querySelector("#class summary").click());
    must(await words("class-answer"), (answer) => answer.length > 10 && shows("class-answer"), `an answer of ${name}`);
    const { address } = await told();
    const [picture, link] = [await sum(), await words("class-link")];
    must(link, () => link.endsWith(`#class?${address}`), `a link to ${address}`);
    await isWritten(new RegExp(`^#class\\?figure=${name}&`));
    await ask((address) => void (location.hash = `#class?${address}`), `${address}&`);
    await settle();
    assert.deepEqual([await sum(), (await told()).address], [picture, address], `the link of ${name}`);
    if (place < 12) await redraw("the next figure", () => press("class-after"));
  }
  assert.equal(await shows("class-after"), false);
});

more("values that the kernel refuses are said, and change nothing", async () => {
  await open("#class?figure=cones&which=inner");
  const before = await told();
  await enter("class-number-0", 30);
  assert.match(await words("class-error-0"), /^Inner half angle = 30: expected 0 to 20 degrees$/);
  assert.deepEqual(await told(), before);
  await open("#class?figure=none&fbclid=1");
  assert.match(await words("class-error-0"), /^figure = "none": expected one of the list$/);
  await open("#class?figure=both&beam=8&field=140");
  assert.match(await words("class-refused"), /field angle = 140: expected 8 to 18.*nearest pair/);
  assert.equal(await value("class-number-1"), "140");
});
