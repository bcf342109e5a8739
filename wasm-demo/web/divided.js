// The other half of a divided picture: the same scene, camera and time in another number format.
import { Divided } from "./pkg/wasm_demo.js";
import { apart } from "./apart.js";
import { Divider } from "./divider.js";
import { element as find, encircle } from "./elements.js";
import { colours, counted } from "./numbers.js";
import { plain } from "./plain.js";
import { Pool } from "./pool.js";
import { Screen } from "./screen.js";

/** @typedef {ReturnType<typeof plain<Divided>>} Difference */

/**
 * The formats on the two sides of the edge.
 * @type {Record<string, string>}
 */
const NAMES = { fx16: "16-bit integers", fx32: "32-bit integers", f32: "32-bit floats" };

/**
 * @template {Element} [T=HTMLElement]
 * @param {string} name
 * @param {abstract new (...args: any) => T} [kind]
 */
const element = (name, kind) => find(`divided${name}`, kind);

export class DividedPicture {
  #module;
  #count;
  /**
   * Draws the other half; there is none while the picture is whole.
   * @type {Pool | undefined}
   */
  #pool;
  /** @type {Screen | undefined} */
  #screen;
  /**
   * The job that is drawn.
   * @type {string | undefined}
   */
  #job;
  #isShown = true;
  #names = ["", ""];

  /** The edge between both halves. */
  divider = new Divider(find("frame"));

  /**
   * The difference between both halves: a plain object.
   * @type {Difference | undefined}
   */
  difference;

  /**
   * @param {WebAssembly.Module} module
   * @param {number} count how many workers draw the other half
   */
  constructor(module, count) {
    this.#module = module;
    this.#count = count;
    element("-bar").style.background = `linear-gradient(90deg, ${colours(Divided.palette()).join()})`;
  }

  /**
   * Whether a job is drawn; without a job, whether the picture is whole.
   * @param {string} [job]
   */
  hasDrawn(job) {
    return job === this.#job;
  }

  /**
   * Draws the other half, after the picture itself. Without a job the picture is whole.
   * @param {string | undefined} job
   * @param {{ width: number, height: number }} size
   */
  async draw(job, size) {
    if (job === this.#job) return;
    this.#job = undefined;
    if (job === undefined) return this.#end();
    this.#pool ??= new Pool(Promise.resolve(this.#module), this.#count);
    this.#screen ??= new Screen(element("-other", HTMLCanvasElement), element("-difference", HTMLCanvasElement));
    const { isDrawn, parts } = await this.#pool.draw(job);
    if (isDrawn) this.#screen.gather(parts, size);
    this.#pool.recycle(parts);
    element("").style.setProperty("--aspect", String(size.width / size.height));
    this.#job = job;
    this.#isShown = false;
  }

  /**
   * Shows the other half and its difference from the picture, if either has changed. Returns whether
   * it did.
   * @param {Uint8ClampedArray} pixels of the picture
   * @param {boolean} isChanged whether the picture has changed
   * @param {number} width of the picture
   */
  show(pixels, isChanged, width) {
    if (!this.#screen || this.#job === undefined || (this.#isShown && !isChanged)) return false;
    const bytes = [pixels, this.#screen.pixels].map(({ buffer, byteOffset, length }) => new Uint8Array(buffer, byteOffset, length));
    const divided = new Divided(bytes[0], bytes[1]);
    this.#screen.show();
    this.#screen.showMap(divided.pixels());
    this.difference = plain(divided);
    if (!element("-note").hidden) this.#tell(this.difference, width, pixels.length / 4);
    this.#isShown = true;
    return true;
  }

  /**
   * Divides the picture between two formats or not, and covers it with the difference or uncovers it.
   * @param {string} format of the picture
   * @param {string | undefined} other format of the other half; none for a picture that is whole
   * @param {boolean} isDifference
   */
  cover(format, other, isDifference) {
    element("-difference").hidden = !isDifference;
    for (const part of ["-key", "-switch", "-note"]) element(part).hidden = other === undefined;
    this.divide(format, other);
  }

  /**
   * Shows the other half without what is said of it, or a picture that is whole.
   * @param {string} format of the picture
   * @param {string | undefined} other format of the other half
   */
  divide(format, other) {
    element("").hidden = other === undefined;
    if (other === undefined) return;
    this.#names = [NAMES[format], NAMES[other]];
    this.divider.left = this.#names[0];
    element("").querySelectorAll(".badge").forEach((badge, side) => (badge.textContent = this.#names[side]));
  }

  /**
   * @param {Difference} difference
   * @param {number} width of the picture
   * @param {number} pixels their number
   */
  #tell({ largest, place, differing, beyond, end }, width, pixels) {
    const [x, y] = [place % width, Math.floor(place / width)];
    element("-note").textContent =
      largest === 0
        ? "Both halves are equal, pixel by pixel."
        : `${this.#names[0]}: ${apart({ pixels, differing, beyond, most: largest }, this.#names[1])} (ring, at ${x}, ${y}).`;
    element("-end").textContent = counted(end, "code");
    element("-bar").setAttribute("aria-label", `From no difference, dark blue, to ${counted(end, "code")}, pale yellow`);
    encircle(element("-ring"), largest > 0, place, { width, height: pixels / width });
  }

  #end() {
    this.#pool?.end();
    this.#pool = undefined;
    this.difference = undefined;
  }
}
