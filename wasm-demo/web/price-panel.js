// What the selected light costs on each chip, by each evaluation, and which one is enough.
import { element as find, fetchText, row } from "./elements.js";
import { refusalOf } from "./failure.js";
import { tidy, whole } from "./numbers.js";
import { draw } from "./price-chart.js";
import { load } from "./support.js";

/** @typedef {import("./price-slot.js").Light} Light */
/** @typedef {{ instructions: number, cycles: number | null, bytes: number, counted: "whole" | "parts" }} Price of a lit point */

/**
 * A chip: what the rest of a picture takes for each evaluation.
 * @typedef {object} Chip
 * @property {string} name
 * @property {string} title
 * @property {string} part
 * @property {number} megahertz
 * @property {Record<string, { instructions: number, cycles: number | null }>} rest
 */

/**
 * The chips, and how many pixels of their picture a light reaches.
 * @typedef {{ chips: Chip[], reached: number, pixels: number }} Chips
 */

/**
 * An evaluation of a light, its error and its price on each chip.
 * @typedef {{ evaluation: string, bound: { value: number, found: number, label: string }, prices: Record<string, Price> }} Evaluation
 */

/** @typedef {{ evaluations: Evaluation[], picked: string | null, question: string }} Survey */

/**
 * The names of the evaluations.
 * @type {Record<string, string>}
 */
const NAMES = {
  "fx16-quick": "16 bits, quick",
  fx16: "16 bits",
  fx32: "32 bits",
  f32: "f32",
};

/** @param {string} id */
const element = (id) => find(`price-${id}`);
/** @param {string} id */
const select = (id) => find(`price-${id}`, HTMLSelectElement);

/**
 * The digits of an error that matter.
 * @param {number} value
 */
const digits = (value) => String(Number(value.toPrecision(2)));

/**
 * A light of the stage as the picker has it. Its surfaces are between two distances, or without
 * them from half to twice its throw.
 * @param {Record<string, any>} own the light in a document, whose intensity is in units of the scene
 * @param {Pick<Light, "intensity"> & { throw?: number }} light
 * @param {number[]} [distances] in metres
 */
export function described(own, { intensity, throw: reach = 6 }, distances) {
  const [near = reach / 2, far = 2 * reach] = distances ?? [];
  /** @type {Record<string, any>} */
  const light = { ...own, intensity };
  for (const member of ["name", "near", "far"]) delete light[member];
  return { light, near, far };
}

/**
 * What a picture costs on a chip whose lit points take these amounts: instructions, cycles where
 * they are counted, and the time of one clock a cycle, or an instruction, in milliseconds.
 * @param {Pick<Chips, "reached">} chips
 * @param {Pick<Chip, "rest" | "megahertz">} chip
 * @param {string} evaluation
 * @param {Pick<Price, "instructions" | "cycles">} price
 */
export function picture(chips, chip, evaluation, price) {
  const rest = chip.rest[evaluation];
  const instructions = rest.instructions + chips.reached * price.instructions;
  const cycles = price.cycles && rest.cycles ? rest.cycles + chips.reached * price.cycles : null;
  return { instructions, cycles, milliseconds: (cycles ?? instructions) / (1000 * chip.megahertz) };
}

export class PricePanel {
  #chips;
  #code;
  #worker;
  /** @type {Light | undefined} */
  #light;
  #format = "";
  /**
   * The question that is being answered.
   * @type {string | undefined}
   */
  #asked;
  /**
   * The last answer, with its question.
   * @type {Survey | undefined}
   */
  #survey;

  /** Called with the number format that the visitor has chosen in the chart. */
  onformat = /** @type {(format: string) => void} */ (() => {});

  /** The largest error that is allowed in the answer that is shown; undefined before the first. */
  get tolerance() {
    return this.#survey && Object.values(JSON.parse(this.#survey.question).tolerance)[0];
  }

  /**
   * Loads the panel into its place.
   * @param {HTMLElement} place
   */
  static async open(place) {
    const [{ openCode }, text, list] = await Promise.all([load("code-drawer.js"), fetchText("price.html"), fetchText("chips.json")]);
    const chips = JSON.parse(list);
    if (chips === null) throw new Error("the page was built without a record of prices. Run cargo xtask measure, and build it again.");
    place.innerHTML = text;
    return new PricePanel(chips, await openCode(), new Worker(new URL("price-worker.js", import.meta.url), { type: "module" }));
  }

  /**
   * @param {Chips} chips
   * @param {import("./pkg/code.js").Code} code
   * @param {Worker} worker
   */
  constructor(chips, code, worker) {
    this.#chips = chips;
    this.#code = code;
    this.#worker = worker;
    worker.onmessage = ({ data }) => this.#hear(data);
    worker.onerror = (event) => this.#tell(`The picker could not be loaded: ${event.message ?? "no module workers"}`);
    for (const { name, title, part, megahertz } of chips.chips) {
      select("chip").add(new Option(`${title} (${part}, ${megahertz} MHz)`, name));
    }
    for (const name of ["chip", "display", "most", "far"]) element(name).addEventListener("input", () => this.#ask());
    new ResizeObserver(() => requestAnimationFrame(() => this.#show())).observe(find("price-chart", SVGElement));
  }

  /**
   * Shows the price of a light in a number format.
   * @param {Light | undefined} light
   * @param {string} format
   */
  show(light, format) {
    this.#light = light;
    this.#format = format;
    element("title").textContent = light === undefined ? "The price" : `The price of the ${light.name}`;
    if (light === undefined) {
      this.#asked = undefined;
      this.#tell("There is no light.");
      return;
    }
    this.#ask();
  }

  /**
   * Shows what a point takes on this machine.
   * @param {string} text
   */
  live(text) {
    element("live").textContent = text;
  }

  /**
   * The question for a light as the stage has it now.
   * @param {Light} light
   */
  #question(light) {
    const [own] = JSON.parse(this.#code.write(light.job(), light.number, "json")).lights;
    const distances = select("far").value === "" ? light.distances() : select("far").value.split(" ").map(Number);
    const display = select("display").value;
    const most = Number(select("most").value);
    const isCodes = display === "codes";
    return JSON.stringify({
      chip: select("chip").value,
      display: isCodes ? "rgb888" : display,
      tolerance: isCodes ? { codes: most } : { steps: most },
      light: described(own, light, distances),
    });
  }

  /**
   * Asks the worker, if it is idle: after an answer it gets the newest question.
   * @param {string} [answered] the question that the worker has just answered
   */
  #ask(answered) {
    const last = select("display").selectedOptions[0].dataset.last;
    element("unit").textContent = last === undefined ? "of 255" : `steps of 1/${last}`;
    const light = this.#light;
    if (!light) return;
    let question = "";
    const refusal = refusalOf(() => (question = this.#question(light)));
    if (refusal !== "") return this.#tell(refusal);
    if (this.#asked !== undefined || question === answered) return;
    if (this.#survey?.question === question) {
      this.#tell("");
      return this.#show();
    }
    this.#asked = question;
    this.#worker.postMessage(question);
  }

  /** @param {{ survey?: Omit<Survey, "question">, refusal?: string, failure?: string }} answer */
  #hear({ survey, refusal, failure }) {
    const question = this.#asked;
    this.#asked = undefined;
    if (question === undefined || !this.#light) return;
    if (survey) {
      this.#survey = { ...survey, question };
      this.#tell("");
      this.#show();
    } else {
      this.#tell(failure ?? refusal ?? "");
    }
    this.#ask(question);
  }

  /** @param {string} text */
  #tell(text) {
    element("refusal").textContent = text;
    document.querySelector("#price .priced")?.toggleAttribute("hidden", text !== "");
  }

  #show() {
    if (!this.#survey) return;
    const { evaluations, picked } = this.#survey;
    const name = select("chip").value;
    const most = Number(select("most").value);
    const unit = element("unit").textContent ?? "";
    const points = evaluations.map(({ evaluation, bound, prices }) => ({
      name: NAMES[evaluation],
      cost: prices[name].instructions,
      error: bound.value,
      isStage: evaluation === this.#format,
      isPicked: evaluation === picked,
      onpick: evaluation === "fx16-quick" ? undefined : () => this.onformat(evaluation),
    }));
    draw(find("price-chart", SVGElement), points, { tolerance: most, cost: "instructions a lit point", error: `error, ${unit}` });
    this.#showPicked(evaluations.find(({ evaluation }) => evaluation === picked), name, unit);
    this.#showChips(evaluations.find(({ evaluation }) => evaluation === this.#format));
  }

  /**
   * @param {Evaluation | undefined} found
   * @param {string} name of the chip
   * @param {string} unit
   */
  #showPicked(found, name, unit) {
    const [strong, words, small] = ["b", "span", "small"].map((kind) => document.createElement(kind));
    if (found === undefined) {
      strong.textContent = "none";
      words.textContent = "is within the allowed error.";
    } else {
      const { instructions, cycles, bytes } = found.prices[name];
      strong.textContent = NAMES[found.evaluation];
      words.textContent = `is the cheapest within the allowed error: ${whole(instructions)} instructions a lit point`;
      small.textContent =
        `error found ${digits(found.bound.found)}, bound ${digits(found.bound.value)} ${unit}; ` +
        `${cycles === null ? "" : `${whole(cycles)} cycles, `}${whole(bytes)} bytes of code`;
      words.append(small);
    }
    element("picked").replaceChildren(strong, words);
  }

  /**
   * Shows the price of the stage's format on every chip.
   * @param {Evaluation | undefined} found
   */
  #showChips(found) {
    element("format").textContent = NAMES[this.#format];
    const rows = this.#chips.chips.map((chip) => {
      const price = found?.prices[chip.name];
      if (!price) return row(chip.title, ["–", "–", "–"]);
      const { cycles, milliseconds } = picture(this.#chips, chip, found.evaluation, price);
      const time = `${cycles === null ? "≥ " : ""}${tidy(milliseconds)} ms`;
      return row(chip.title, [whole(price.instructions), price.cycles === null ? "–" : whole(price.cycles), time]);
    });
    element("chips").replaceChildren(...rows);
    element("note").textContent =
      `The picture is the one that the boards draw, ${whole(this.#chips.reached)} of its ${whole(this.#chips.pixels)} pixels lit by such a light; ` +
      "estimated from the counted prices, within 10 %. Where cycles are not counted, at one for each instruction." +
      (found?.prices[select("chip").value].counted === "parts" ? " The price of this light is the sum of counted parts." : "");
  }
}
