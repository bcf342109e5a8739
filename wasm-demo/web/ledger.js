// Errors and costs of both forms, side by side.
import { element, row } from "./elements.js";
import { degrees, median, percent, tidy } from "./numbers.js";
import { apart } from "./apart.js";
import { amount, isNumber, price, stageName, targetName } from "./price-list.js";

/** @typedef {import("./pkg/comparison.js").Comparison} Comparison */
/** @typedef {import("./plain.js").Plain<import("./pkg/comparison.js").SideState>} State of a side */
/** @typedef {import("./pkg/comparison.js").FormState} Form */
/** @typedef {import("./price-list.js").Cost} Cost */

/** Number of timings of each picture; the two pictures alternate. */
const RUNS = 9;

/** Delay after a change until the visitor has probably stopped sliding, in milliseconds. */
const REST = 250;

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Smallest error that is shown, in codes. */
const LEAST = 0.001;

/**
 * Formats an error in codes, with two digits.
 * @param {number} value
 */
function codes(value) {
  if (value === 0) return "none";
  if (value < LEAST) return `under ${LEAST}`;
  return String(value < 10 ? Number(value.toPrecision(2)) : Math.round(value));
}

/**
 * States how far the pictures of both forms are from the exact one here, and at what cost.
 * @param {State[]} states
 * @param {boolean} isOneCurve
 * @param {(Cost | undefined)[][]} costs of both sides, for each target
 */
function verdict(states, isOneCurve, costs) {
  const refused = ["A", "B"].filter((_, side) => states[side]?.refusal !== undefined);
  if (refused.length === 2) return "Neither format can represent a beam this narrow.";
  if (refused.length === 1) return `Format ${refused[0]} cannot represent a beam this narrow.`;
  if (!isOneCurve) {
    return "A and B are different curves, each compared with its own f64: compare their shapes, not their errors.";
  }
  const judged = states.map(({ differing = 0, apart: most = 0 }, side) => {
    return `${"AB"[side]}: ${apart({ pixels: 1, differing, most }, "64-bit floats")}`;
  });
  return `${judged.join(". ")}${priceOf(costs.map(([a, b]) => (b?.instructions ?? NaN) / (a?.instructions ?? NaN)))}.`;
}

/**
 * Formats the range of some ratios of instructions; empty without any.
 * @param {number[]} ratios
 */
function priceOf(ratios) {
  const known = ratios.filter(Number.isFinite).map((ratio) => Number(ratio.toPrecision(2)));
  if (known.length === 0) return "";
  const [least, most] = [Math.min(...known), Math.max(...known)];
  return `, for ${least === most ? least : `${least} to ${most}`} times the instructions of A`;
}

export class Ledger {
  #comparison;
  #forms;
  #prices;
  #costs = element("costs");
  #note = element("costs-note");
  #measurement = 0;

  /**
   * Resolves when the times of the current pictures are shown, or when newer pictures replace them.
   * @type {Promise<void> | undefined}
   */
  measured;

  /**
   * @param {Comparison} comparison
   * @param {Map<string, Form>} forms by name
   * @param {import("./price-list.js").PriceList} prices
   */
  constructor(comparison, forms, prices) {
    this.#comparison = comparison;
    this.#forms = forms;
    this.#prices = prices;
  }

  /**
   * Shows the state of both sides, and measures the rest.
   * @param {State[]} states
   */
  show(states) {
    for (const [side, state] of states.entries()) this.#tell(side, state);
    const forms = states.map((state) => this.#form(state));
    element("verdict").textContent = verdict(
      states,
      this.#comparison.isOneCurve,
      this.#showCosts(forms),
    );
    this.measured = this.#measure();
  }

  /** @param {State} state */
  #form(state) {
    return /** @type {Form} */ (this.#forms.get(state.form));
  }

  /**
   * @param {number} side
   * @param {State} state
   */
  #tell(side, state) {
    /** @type {(name: string, text: string) => void} */
    const put = (name, text) => {
      element(`${name}-${side}`).textContent = text;
    };
    const { label, truth } = this.#form(state);
    const { largest = NaN, offAxis = NaN, differing = NaN } = state;
    const held = state.refusal === undefined;
    put("name", label);
    put("truth", truth);
    put("largest", held ? codes(largest) : "refused");
    element(`largest-${side}`).classList.toggle("no", !held);
    put("where", held && largest > 0 ? degrees(Number(offAxis.toPrecision(2))) : "–");
    put("differing", held ? percent(differing, "none") : "–");
    put("time", held ? "…" : "–");
  }

  /**
   * Compares both in the same stage: the lit point if both have one. Returns the costs by target.
   * @param {Form[]} forms
   */
  #showCosts(forms) {
    const list = this.#prices;
    if (list.isEmpty) {
      this.#costs.replaceChildren();
      this.#note.replaceChildren(...list.lack());
      return [];
    }
    const stage = forms.every((form) => form.lit.length > 0) ? "lit" : "falloff";
    // The price of the other views is that with the inverse square, which some forms have not.
    const whole = forms.map(({ lit: [, format] }) => list.find("lit", "lit-inverse-square", format));
    const isWhole = whole.every(Boolean);
    const lit = isWhole ? whole : forms.map((form) => list.find("lit", ...form.lit));
    const falloff = forms.map((form) => list.find("falloff", ...form.falloff));
    const rows = stage === "lit" ? lit : falloff;
    const costs = list.targets.map((target) => rows.map((row) => row?.cost?.[target]));
    this.#costs.replaceChildren(
      heading(`Cost of ${stageName(stage)}${stage === "lit" && !isWhole ? " without attenuation" : ""}`),
      ...list.targets.map((target, i) => bars(target, costs[i])),
    );
    this.#note.textContent =
      "Numbers without a unit are exact counts of instructions, from the project's price list." +
      (stage === "lit" ? "" : " Formulas are on it by their falloff alone.");
    return costs;
  }

  /** Times both pictures alternately, so that other load affects both. A newer change ends it. */
  async #measure() {
    const measurement = (this.#measurement += 1);
    const isOver = () => measurement !== this.#measurement;
    await pause(REST);
    /** @type {(number | undefined)[][]} */
    const times = [[], []];
    for (let run = 0; run < RUNS; run += 1) {
      for (const side of [0, 1]) {
        if (isOver()) return;
        times[side]?.push(this.#comparison.time(side));
        // Yields to the browser.
        await pause(0);
      }
    }
    if (isOver()) return;
    for (const [side, taken] of times.entries()) {
      if (taken.every(isNumber)) element(`time-${side}`).textContent = `${tidy(median(taken))} ms`;
    }
  }

  /** Stops measuring when the view is hidden. */
  stop() {
    this.#measurement += 1;
  }
}

/** @param {string} text */
function heading(text) {
  const line = row(text, []);
  Object.assign(line.cells[0], { colSpan: 3, scope: "rowgroup" });
  return line;
}

/**
 * Shows the costs on a target as bars; the longer bar is full.
 * @param {string} target
 * @param {(Cost | undefined)[]} costs
 */
function bars(target, costs) {
  const most = Math.max(...costs.map(amount).filter(isNumber));
  const line = row(targetName(target), costs.map(price));
  line.className = "bars";
  for (const [i, cost] of costs.entries()) {
    const part = amount(cost) / most;
    line.cells[i + 1].style.setProperty("--part", `${Number.isFinite(part) ? 100 * part : 0}%`);
  }
  return line;
}
