// The three lights, one panel at a time.
import { LightPanel } from "./light-panel.js";
import { roughly } from "./numbers.js";

export class LightDesk {
  #demo;
  #tabs;
  #panels;

  /** The index of the visible light. */
  selected = 0;
  /** Called with a changed light. */
  onchange = () => {};
  /** Called with the light that becomes visible. */
  onselect = () => {};

  constructor(demo) {
    this.#demo = demo;
    const lights = Array.from({ length: demo.lights }, (_, light) => light);
    this.#panels = lights.map((light) => this.#panel(light));
    this.#tabs = lights.map((light) => this.#tab(light));
    document.getElementById("tabs").append(...this.#tabs);
    document.getElementById("panels").append(...this.#panels.map((panel) => panel.element));
    document.getElementById("tabs").addEventListener("keydown", (event) => this.#key(event));
    for (const light of lights) this.#label(light);
  }

  /** Shows the panel of a light. */
  select(light) {
    this.selected = light;
    for (const [i, tab] of this.#tabs.entries()) {
      tab.setAttribute("aria-selected", i === light);
      tab.tabIndex = i === light ? 0 : -1;
      this.#panels[i].element.hidden = i !== light;
    }
    this.onselect(light);
  }

  /** Shows the current state of the lights. */
  refresh() {
    for (const [light, panel] of this.#panels.entries()) {
      panel.refresh();
      this.#label(light);
    }
  }

  /** Shows why a number format can't hold a light; empty if it can. */
  object(light, objection) {
    this.#panels[light].object(objection);
  }

  #panel(light) {
    const panel = new LightPanel(this.#demo, light);
    panel.element.id = `panel-${light}`;
    panel.element.setAttribute("aria-labelledby", `tab-${light}`);
    panel.onchange = () => {
      this.#label(light);
      this.onchange(light);
    };
    panel.ontell = () => this.#label(light);
    // A visitor who uses a control of a light wants to see that light.
    panel.element.addEventListener("input", () => this.selected === light || this.select(light));
    return panel;
  }

  #tab(light) {
    const tab = document.getElementById("tab").content.firstElementChild.cloneNode(true);
    tab.id = `tab-${light}`;
    tab.setAttribute("aria-controls", `panel-${light}`);
    tab.addEventListener("click", () => this.select(light));
    return tab;
  }

  /** Shows the light's state on its tab. */
  #label(light) {
    const tab = this.#tabs[light];
    const state = this.#demo.light(light);
    tab.querySelector(".name").textContent = state.name;
    tab.style.setProperty("--light", state.color);
    tab.classList.toggle("off", !state.on);
    tab.querySelector(".angles").textContent = state.on
      ? `${roughly(state.beam)} / ${roughly(state.field)}`
      : "off";
    tab.querySelector(".alarm").hidden = this.#panels[light].error === "";
    state.free();
  }

  #key(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    this.select((this.selected + step + this.#demo.lights) % this.#demo.lights);
    this.#tabs[this.selected].focus();
  }
}
