// The controls of the state's parameters: what each offers is in the module's table of parameters.
import { Stage } from "./pkg/wasm_demo.js";
import { find, showPart } from "./elements.js";

/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {import("./pkg/wasm_demo.js").ParameterState} Parameter */

/** The elements that control a parameter name it by `data-parameter`. */
export class Controls {
  #stage;
  /** @type {{ control: Control, row: Parameter }[]} */
  #controls = [];

  /**
   * @param {Stage} stage
   * @param {(act: () => void) => void} onchange called with a change of the state
   */
  constructor(stage, onchange) {
    this.#stage = stage;
    for (const row of Stage.parameters()) {
      const control = /** @type {Control | null} */ (document.querySelector(`[data-parameter=${row.name}]`));
      if (!control) continue;
      offer(control, row);
      control.addEventListener("input", () => onchange(() => stage.set(row.name, valueOf(control))));
      this.#controls.push({ control, row });
    }
  }

  /** Shows the state. */
  show() {
    for (const { control, row } of this.#controls) show(control, row, this.#stage.get(row.name));
  }
}

/**
 * Gives a control what its parameter offers.
 * @param {Control} control
 * @param {Parameter} row
 */
function offer(control, { range: [least, most, step], choices }) {
  if (control instanceof HTMLSelectElement) {
    for (let i = 0; i < choices.length; i += 2) control.append(new Option(choices[i + 1], choices[i]));
  } else if (step !== undefined) Object.assign(control, { min: least, max: most, step });
}

/**
 * The value that a control is set to: nothing for a choice without a name.
 * @param {Control} control
 */
function valueOf(control) {
  if (control instanceof HTMLSelectElement) return control.value || undefined;
  return control.type === "checkbox" ? control.checked : control.valueAsNumber;
}

/**
 * @param {Control} control
 * @param {Parameter} row
 * @param {any} value
 */
function show(control, { symbol }, value) {
  if (control instanceof HTMLInputElement && control.type === "checkbox") {
    control.checked = value;
    return;
  }
  control.value = String(value);
  if (!(control instanceof HTMLInputElement)) return;
  showPart(control);
  const text = `${value > 0 ? "+" : ""}${value} ${symbol}`;
  find(document, `output[for=${control.id}]`).textContent = text.replace("-", "−");
}
