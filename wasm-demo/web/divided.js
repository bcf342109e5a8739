// The other half of a divided picture: the same scene, camera and time in another number format.
import { Divided } from "./pkg/wasm_demo.js";
import { Divider } from "./divider.js";
import { colours } from "./numbers.js";
import { plain } from "./plain.js";
import { Pool } from "./pool.js";
import { Screen } from "./screen.js";

const element = (name) => document.getElementById(`divided${name}`);

/** Formats a number of codes. */
const counted = (codes) => `${codes} ${codes === 1 ? "code" : "codes"}`;

export class DividedPicture {
  #module;
  #count;
  /** Draws the other half; there is none while the picture is whole. */
  #pool;
  #screen;
  /** The job that is drawn. */
  #job;
  #isShown = true;

  /** The difference between both halves: a plain object. */
  difference;

  /**
   * @param {WebAssembly.Module} module
   * @param {number} count how many workers draw the other half
   */
  constructor(module, count) {
    this.#module = module;
    this.#count = count;
    new Divider(document.getElementById("frame"));
    element("-bar").style.background = `linear-gradient(90deg, ${colours(Divided.palette()).join()})`;
  }

  /** Whether a job is drawn; without a job, whether the picture is whole. */
  hasDrawn(job) {
    return job === this.#job;
  }

  /** Draws the other half, after the picture itself. Without a job the picture is whole. */
  async draw(job, size) {
    if (job === this.#job) return;
    this.#job = undefined;
    if (job === undefined) return this.#end();
    this.#pool ??= new Pool(Promise.resolve(this.#module), this.#count);
    this.#screen ??= new Screen(element("-other"), element("-difference"));
    const { isDrawn, parts } = await this.#pool.draw(job);
    if (isDrawn) this.#screen.gather(parts, size);
    this.#pool.recycle(parts);
    element("").style.setProperty("--aspect", size.width / size.height);
    this.#job = job;
    this.#isShown = false;
  }

  /**
   * Shows the other half and its difference from the picture, if either has changed. Returns whether
   * it did.
   */
  show(pixels, isChanged, width) {
    if (this.#job === undefined || (this.#isShown && !isChanged)) return false;
    const divided = new Divided(pixels, this.#screen.pixels);
    this.#screen.show();
    this.#screen.showMap(divided.pixels());
    this.difference = plain(divided);
    this.#tell(this.difference, width, pixels.length / 4);
    this.#isShown = true;
    return true;
  }

  /** Shows the state, and covers the picture with the difference or uncovers it. */
  cover(format, isDifference) {
    const isDivided = format !== undefined;
    element("-format").value = format ?? "";
    element("-cover").checked = isDifference;
    element("-difference").hidden = !isDifference;
    for (const part of ["", "-key", "-switch", "-note"]) element(part).hidden = !isDivided;
  }

  #tell({ largest, place, differing, end }, width, pixels) {
    const share = Number(((100 * differing) / pixels).toPrecision(2));
    const [x, y] = [place % width, Math.floor(place / width)];
    element("-note").textContent =
      largest === 0
        ? "A and B are equal, pixel by pixel."
        : `A and B differ by at most ${counted(largest)} (ring, at ${x}, ${y}), and at ${share} % of the pixels.`;
    element("-end").textContent = counted(end);
    element("-bar").setAttribute("aria-label", `From no difference, dark blue, to ${counted(end)}, pale yellow`);
    const ring = element("-ring");
    ring.hidden = largest === 0;
    ring.style.left = `${(100 * (x + 0.5)) / width}%`;
    ring.style.top = `${(100 * (y + 0.5)) / (pixels / width)}%`;
  }

  #end() {
    this.#pool?.end();
    this.#pool = undefined;
    this.difference = undefined;
  }
}
