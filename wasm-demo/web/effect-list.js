// The effects of the library: those that the scene needs, and switches for some of them.
import { plain } from "./plain.js";
import { load } from "./support.js";

/** Delay before the prices are loaded, in milliseconds: the first picture goes before them. */
const LATER = 500;

export class EffectList {
  #stage;
  #list = document.getElementById("effects");
  #count = document.getElementById("effects-count");
  #switches = document.getElementById("switches");
  /** The displayed text, so that the page is written only on a change. */
  #shown = "";

  #prices = new Map();

  /** Called with an effect to switch off or on; returns whether the switch was accepted. */
  onswitch = () => false;

  constructor(stage) {
    this.#stage = stage;
    setTimeout(() => this.#price().catch(reportError), LATER);
  }

  /** Shows the price of each switch, once the list of prices has loaded. */
  async #price() {
    const { MEANING, loadPrices } = await load("effect-prices.js");
    this.#prices = await loadPrices();
    if (this.#prices.size > 0) document.getElementById("switches-note").textContent = MEANING;
    for (const input of document.querySelectorAll("[id^='effect-']")) this.#tellPrice(input);
  }

  #tellPrice(input) {
    input.parentElement.querySelector("small").textContent = this.#prices.get(input.id.slice("effect-".length)) ?? "";
  }

  /** Shows the switches of the current scene. */
  open() {
    this.#switches.replaceChildren(...this.#stage.switches().map((state) => this.#switch(plain(state))));
    this.show();
  }

  /** Shows the effects that the picture needs. */
  show() {
    const effects = this.#stage.effects().map(plain);
    const called = effects.filter(({ isCalledFor }) => isCalledFor);
    const shown = called.map(({ name }) => name).join();
    if (shown === this.#shown && this.#list.childElementCount > 0) return;
    this.#shown = shown;
    this.#count.textContent = `${called.length} of ${effects.length}`;
    this.#list.replaceChildren(...effects.map(item));
  }

  #switch({ effect, label, offered, on }) {
    const holder = document.getElementById("switch").content.firstElementChild.cloneNode(true);
    const input = holder.querySelector("input");
    input.id = `effect-${effect}`;
    input.checked = offered && on;
    input.disabled = !offered;
    holder.querySelector("span").textContent = label;
    this.#tellPrice(input);
    input.addEventListener("input", () => {
      if (!this.onswitch(effect, input.checked)) input.checked = !input.checked;
    });
    return holder;
  }
}

function item({ name, isCalledFor }) {
  const item = document.createElement("li");
  item.textContent = name;
  item.dataset.effect = name;
  item.classList.toggle("called", isCalledFor);
  if (!isCalledFor) {
    const words = document.createElement("span");
    words.className = "unseen";
    words.textContent = ", left out";
    item.append(words);
  }
  return item;
}
