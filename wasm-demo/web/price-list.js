// The price list made by `cargo xtask measure`: the cost of each kernel on each target.
import { made } from "./elements.js";
import { words } from "./failure.js";
import { tidy, whole } from "./numbers.js";

/**
 * A cost: exact instructions, or measured nanoseconds.
 * @typedef {{ instructions?: number, ns?: number }} Cost
 */

/**
 * A row of the list: a kernel in a format.
 * @typedef {object} Row
 * @property {string} stage
 * @property {string} kernel
 * @property {string} format
 * @property {Record<string, Cost>} [cost] by target
 */

/**
 * Names of the targets, in display order.
 * @type {Record<string, string>}
 */
const TARGETS = {
  "cortex-m0": "Cortex-M0",
  "cortex-m3": "Cortex-M3",
  "cortex-m4f": "Cortex-M4F",
  rv32imc: "RV32IMC",
  "cortex-m7": "Cortex-M7",
  "cortex-m33": "Cortex-M33",
  hazard3: "Hazard3",
  host: "host",
  wasm: "browser",
  "wasm-simd": "browser, SIMD",
};

/** @type {Record<string, string>} */
const STAGES = { lit: "a lit point", falloff: "the intensity alone" };

/**
 * Returns the name of a stage within a sentence.
 * @param {string} stage
 */
export const stageName = (stage) => STAGES[stage];

/**
 * Returns the name of a target.
 * @param {string} target
 */
export const targetName = (target) => TARGETS[target] ?? target;

/**
 * Formats a cost with its unit.
 * @param {Cost} [cost]
 */
export function price(cost) {
  if (isNumber(cost?.instructions)) return whole(cost.instructions);
  return isNumber(cost?.ns) ? `${tidy(cost.ns)} ns` : "–";
}

/**
 * Returns the bare number, to compare costs on one target; NaN if there is none.
 * @param {Cost} [cost]
 */
export const amount = (cost) => [cost?.instructions, cost?.ns].find(isNumber) ?? NaN;

/**
 * Returns whether a value of the list is a number.
 * @param {unknown} value
 * @returns {value is number}
 */
export function isNumber(value) {
  return Number.isFinite(value);
}

/**
 * Returns the rows of the record: the kernels with an error, and their costs by target.
 * @param {Record<string, { figures: Record<string, Cost & { stage?: string }> }>} record
 * @returns {Row[]}
 */
function rowsOf(record) {
  return Object.entries(record.errors?.figures ?? {}).map(([name, { stage = "" }]) => {
    const [kernel, format] = name.split(".");
    const costs = Object.keys(TARGETS).map((target) => [target, record[target]?.figures[name]]);
    const cost = Object.fromEntries(costs.filter(([, cost]) => cost));
    return { stage, kernel, format, cost };
  });
}

export class PriceList {
  #rows;
  #problem;

  /** Loads the list. A list that is missing or can't be loaded is empty. */
  static async load() {
    try {
      const answer = await fetch(new URL("prices.json", import.meta.url));
      if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
      return new PriceList(rowsOf((await answer.json()) ?? {}));
    } catch (error) {
      return new PriceList([], words(error));
    }
  }

  /**
   * @param {Row[]} rows
   * @param {string} [problem] why there are no rows, if not for want of a list
   */
  constructor(rows, problem) {
    this.#rows = rows;
    this.#problem = problem;
  }

  /** Whether the list is missing. */
  get isEmpty() {
    return this.#rows.length === 0;
  }

  /** Why the list is empty, and the remedy. */
  lack() {
    if (this.#problem) return [`The price list could not be loaded: ${this.#problem}. Reload the page to try again.`];
    const command = made("code", {}, "cargo xtask measure");
    return ["This page was built without a price list. Run ", command, ", and build the page again."];
  }

  /**
   * Returns the row of a kernel, or undefined.
   * @param {string} stage
   * @param {string} [kernel]
   * @param {string} [format]
   */
  find(stage, kernel, format) {
    return this.#rows.find((row) => row.stage === stage && row.kernel === kernel && row.format === format);
  }

  /** Returns every target with a cost in a row; those without a name come last. */
  get targets() {
    const listed = new Set(this.#rows.flatMap((row) => Object.keys(row.cost ?? {})));
    return [...new Set([...Object.keys(TARGETS), ...listed])].filter((target) => listed.has(target));
  }
}
