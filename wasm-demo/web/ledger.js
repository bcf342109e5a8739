// Errors and costs of both forms, side by side.
import { degrees, median, tidy } from "./numbers.js";
import { amount, price, stageName, targetName } from "./price-list.js";

/** Number of timings of each picture; the two pictures alternate. */
const RUNS = 9;

/** Delay after a change until the visitor has probably stopped sliding, in milliseconds. */
const REST = 250;

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Smallest error that is shown, in codes. */
const LEAST = 0.001;

/** Formats an error in codes, with two digits. */
function codes(value) {
  if (value === 0) return "none";
  if (value < LEAST) return `under ${LEAST}`;
  return String(value < 10 ? Number(value.toPrecision(2)) : Math.round(value));
}

/** Formats a share in percent. */
const percent = (share) =>
  share === 0 ? "none" : `${Number((100 * share).toPrecision(share < 0.1 ? 2 : 3))} %`;

/** States in one sentence which form is better here, by how much, and at what cost. */
function verdict(states, isOneCurve, costs) {
  const refused = ["A", "B"].filter((_, side) => states[side].refusal !== undefined);
  if (refused.length === 2) return "Neither format can represent a beam this narrow.";
  if (refused.length === 1) return `Format ${refused[0]} cannot represent a beam this narrow.`;
  if (!isOneCurve) {
    return "A and B are different curves, each compared with its own f64: compare their shapes, not their errors.";
  }
  const better = states[0].largest < states[1].largest ? 0 : 1;
  const [least, most] = [states[better].largest, states[1 - better].largest];
  if (most < LEAST) return "Both are within a thousandth of a code here.";
  const factor = Number((most / Math.max(least, LEAST)).toPrecision(2)).toLocaleString("en");
  const over = least < LEAST ? "over " : "";
  const judged = `${"AB"[better]} is ${over}${factor}× more accurate here`;
  return `${judged}${priceOf(costs.map((pair) => pair[better]?.instructions / pair[1 - better]?.instructions))}.`;
}

/** Formats the range of some ratios of instructions; empty without any. */
function priceOf(ratios) {
  const known = ratios.filter(Number.isFinite).map((ratio) => Number(ratio.toPrecision(2)));
  if (known.length === 0) return "";
  const [least, most] = [Math.min(...known), Math.max(...known)];
  return ` and takes ${least === most ? least : `${least} to ${most}`}× the instructions`;
}

export class Ledger {
  #comparison;
  #forms;
  #prices;
  #costs = document.getElementById("costs");
  #note = document.getElementById("costs-note");
  #measurement = 0;

  /**
   * Resolves when the times of the current pictures are shown, or when newer pictures replace them.
   */
  measured;

  constructor(comparison, forms, prices) {
    this.#comparison = comparison;
    this.#forms = forms;
    this.#prices = prices;
  }

  /** Shows the state of both sides, and measures the rest. */
  show(states) {
    for (const [side, state] of states.entries()) this.#tell(side, state);
    const forms = states.map((state) => this.#forms.get(state.form));
    document.getElementById("verdict").textContent = verdict(
      states,
      this.#comparison.isOneCurve,
      this.#showCosts(forms),
    );
    this.measured = this.#measure();
  }

  #tell(side, state) {
    const put = (name, text) => {
      document.getElementById(`${name}-${side}`).textContent = text;
    };
    const { label, truth } = this.#forms.get(state.form);
    const held = state.refusal === undefined;
    put("name", label);
    put("truth", truth);
    put("largest", held ? codes(state.largest) : "refused");
    document.getElementById(`largest-${side}`).classList.toggle("no", !held);
    put("where", held && state.largest > 0 ? degrees(Number(state.offAxis.toPrecision(2))) : "–");
    put("differing", held ? percent(state.differing) : "–");
    put("time", held ? "…" : "–");
  }

  /**
   * Compares both in the same stage: the lit point if both have one. Returns the costs by target.
   */
  #showCosts(forms) {
    const list = this.#prices;
    if (list.isEmpty) {
      this.#costs.replaceChildren();
      this.#note.replaceChildren(...list.lack());
      list.mark([]);
      return [];
    }
    const stage = forms.every((form) => form.lit.length > 0) ? "lit" : "falloff";
    const rows = forms.map((form) => list.find(stage, ...form[stage]));
    const costs = list.targets.map((target) => rows.map((row) => row?.cost?.[target]));
    this.#costs.replaceChildren(
      heading(`Cost of ${stageName(stage)}`),
      ...list.targets.map((target, i) => bars(target, costs[i])),
    );
    this.#note.textContent =
      "Numbers without a unit are exact counts of instructions, from the price list below." +
      (stage === "lit" ? "" : " Formulas are on it by their falloff alone.");
    list.mark(forms.map((form) => [list.find("lit", ...form.lit), list.find("falloff", ...form.falloff)]));
    return costs;
  }

  /** Times both pictures alternately, so that other load affects both. A newer change ends it. */
  async #measure() {
    const measurement = (this.#measurement += 1);
    const isOver = () => measurement !== this.#measurement;
    await pause(REST);
    const times = [[], []];
    for (let run = 0; run < RUNS; run += 1) {
      for (const side of [0, 1]) {
        if (isOver()) return;
        times[side].push(this.#comparison.time(side));
        // Yields to the browser.
        await pause(0);
      }
    }
    if (isOver()) return;
    for (const [side, taken] of times.entries()) {
      if (taken.includes(undefined)) continue;
      document.getElementById(`time-${side}`).textContent = `${tidy(median(taken))} ms`;
    }
  }

  /** Stops measuring when the view is hidden. */
  stop() {
    this.#measurement += 1;
  }
}

function heading(text) {
  const row = document.createElement("tr");
  const cell = document.createElement("th");
  cell.colSpan = 3;
  cell.scope = "rowgroup";
  cell.textContent = text;
  row.append(cell);
  return row;
}

/** Shows the costs on a target as bars; the longer bar is full. */
function bars(target, costs) {
  const row = document.createElement("tr");
  row.className = "bars";
  const name = document.createElement("th");
  name.scope = "row";
  name.textContent = targetName(target);
  const most = Math.max(...costs.map(amount).filter(Number.isFinite));
  row.append(
    name,
    ...costs.map((cost) => {
      const cell = document.createElement("td");
      cell.textContent = price(cost);
      const part = amount(cost) / most;
      cell.style.setProperty("--part", `${Number.isFinite(part) ? 100 * part : 0}%`);
      return cell;
    }),
  );
  return row;
}
