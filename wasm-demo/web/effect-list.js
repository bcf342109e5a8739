// The effects of the library: those that the scene needs, and switches for some of them.
import { copyOf, element, find, made, onceSeen } from "./elements.js";
import { whole } from "./numbers.js";
import { load } from "./support.js";

/** @typedef {import("./pkg/wasm_demo.js").Stage} Stage */

export class EffectList {
  #stage;
  #list = element("effects");
  #spared = element("spared");
  #count = element("effects-count");
  #switches = element("switches");
  /** The displayed text, so that the page is written only on a change. */
  #shown = "";

  /** @type {Map<string, import("./effect-prices.js").Price>} */
  #prices = new Map();

  /** Called with an effect to switch off or on; returns whether the switch was accepted. */
  onswitch = /** @type {(effect: string, isOn: boolean) => unknown} */ (() => false);

  /** @param {Stage} stage */
  constructor(stage) {
    this.#stage = stage;
    onceSeen([this.#switches, this.#count], () => this.#price().catch(reportError));
  }

  /** Shows the price of each switch, once the list of prices has loaded. */
  async #price() {
    const { MEANING, loadPrices } = await load("effect-prices.js");
    this.#prices = await loadPrices();
    if (this.#prices.size > 0) element("switches-note").textContent = MEANING;
    for (const input of document.querySelectorAll("[id^='effect-']")) this.#tellPrice(input);
    this.#shown = "";
    this.show();
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
    this.show();
  }

  /** Shows the effects that the picture needs. */
  show() {
    const effects = this.#stage.effects();
    const [called, spared] = [true, false].map((isCalled) => effects.filter(({ isCalledFor }) => isCalledFor === isCalled));
    const shown = called.map(({ name }) => name).join();
    if (shown === this.#shown && this.#list.childElementCount > 0) return;
    this.#shown = shown;
    this.#count.textContent = `${called.length} of ${effects.length}`;
    this.#list.replaceChildren(...called.map(item));
    this.#spared.replaceChildren(...spared.map(item));
    const saved = spared.reduce((sum, { name }) => sum + (this.#prices.get(name)?.instructions ?? 0), 0);
    element("spared-count").textContent = `${spared.length} are left out${saved > 0 ? `, which saves over ${whole(saved)} instructions a lit point` : ""}`;
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

/** @param {import("./pkg/wasm_demo.js").EffectState} effect */
const item = ({ name }) => made("li", {}, name);
