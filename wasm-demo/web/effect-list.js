// Switches for effects of the library, with the price of each.
import { copyOf, element, find, onceSeen } from "./elements.js";
import { whole } from "./numbers.js";
import { load } from "./support.js";

/** @typedef {import("./pkg/wasm_demo.js").Stage} Stage */

export class EffectList {
  #stage;
  #switches = element("switches");
  /** @type {Map<string, import("./effect-prices.js").Price>} */
  #prices = new Map();

  /** Called with an effect to switch off or on; returns whether the switch was accepted. */
  onswitch = /** @type {(effect: string, isOn: boolean) => unknown} */ (() => false);

  /** @param {Stage} stage */
  constructor(stage) {
    this.#stage = stage;
    onceSeen([this.#switches], () => this.#price().catch(reportError));
  }

  /** Shows the price of each switch, once the list of prices has loaded. */
  async #price() {
    const { MEANING, loadPrices } = await load("effect-prices.js");
    this.#prices = await loadPrices();
    if (this.#prices.size > 0) element("switches-note").textContent = MEANING;
    for (const input of document.querySelectorAll("[id^='effect-']")) this.#tellPrice(input);
  }

  /** @param {Element} input */
  #tellPrice(input) {
    const price = this.#prices.get(input.id.slice("effect-".length));
    find(/** @type {Element} */ (input.parentElement), "small").textContent =
      price ? `+${whole(price.instructions)}, ${whole(price.flash)} B` : "";
  }

  /** Shows the switches of the current scene. */
  open() {
    this.#switches.replaceChildren(...this.#stage.switches().map((state) => this.#switch(state)));
  }

  /** @param {import("./pkg/wasm_demo.js").SwitchState} state */
  #switch({ effect, label, offered, on }) {
    const holder = copyOf("switch");
    const input = find(holder, "input", HTMLInputElement);
    input.id = `effect-${effect}`;
    input.checked = offered && on;
    input.disabled = !offered;
    find(holder, "span").textContent = label;
    this.#tellPrice(input);
    input.addEventListener("input", () => {
      if (!this.onswitch(effect, input.checked)) input.checked = !input.checked;
    });
    return holder;
  }
}
