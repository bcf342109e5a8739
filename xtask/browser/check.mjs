// The check of the demo, `cargo demo --check`: opens the page, and prints what it measures in a line. Arguments: the
// address and, for `--screenshot`, the file of a picture of the page at 1440 x 900.
import { visit } from "./visit.mjs";

/** Number of frames that are drawn, and of rounds of all workers, of which the best counts. */
const FRAMES = 15;
const ROUNDS = 3;

/** Records when the page is ready to be used, which is when it shows its first picture. */
const READY = `document.addEventListener("DOMContentLoaded", () => {
  new MutationObserver(() => {
    if (document.body.dataset.state === "ready") window.readyAfter ??= performance.now();
  }).observe(document.body, { attributes: true });
})`;

/** The time until then, the scene, and whether a picture that is shown has a pixel that is not black. */
const FIRST = `[readyAfter, luminaire.scene, !document.getElementById("view").checkVisibility() ||
  luminaire.pixels().some((code, i) => i % 4 < 3 && code > 0)]`;

/** Time for the small pictures of the scenes, and for times of more than one picture. */
const PAUSE = `(async () => {
  await new Promise((resolve) => setTimeout(resolve, 3000));
  await luminaire.comparison?.measured;
})()`;

/** Times of frames, and of workers. A picture that plays would take the workers' time. */
const TIMES = `(async () => {
  for (const id of ["play", "camera"]) {
    const box = document.getElementById(id);
    if (box.checked) box.click();
  }
  const { scene } = luminaire;
  return [await luminaire.measureScene(scene, ${FRAMES}), await luminaire.measureCores(scene, ${FRAMES}, ${ROUNDS})];
})()`;

const [address, picture] = process.argv.slice(2);
const taken = picture ? [{ ask: PAUSE }, { picture }] : [];
const { values } = await visit({ address, script: READY }, [{ ask: FIRST }, ...taken, { ask: TIMES }]);
const [ready, scene, isLit] = values[0];
if (!isLit) throw new Error("the page drew nothing: every pixel is black");
const [{ cameraAtRest, cameraMoving }, { workers, togetherPerSecond, apartPerSecond }] = values.at(-1);
const [atRest, moving] = [cameraAtRest, cameraMoving].map((camera) => camera?.frameMs?.toFixed(2));
const frames = [atRest && `${atRest} ms a frame`, moving && `${moving} ms with a moving camera`].filter(Boolean);
const share = (100 * togetherPerSecond) / apartPerSecond;
console.log(
  `demo ok: the first picture after ${ready.toFixed()} ms; ${scene}: ${frames.join(", ") || "nothing moves"}, ` +
    `${togetherPerSecond.toFixed(1)} a second by ${workers} workers, ${share.toFixed()} % of ${workers} independent loops`,
);
