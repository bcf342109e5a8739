// The controls of one light. They show the state from the module and pass on the visitor's
// settings.
import { Dial } from "./dial.js";
import { findFixture, listFixtures } from "./fixture-list.js";
import { ceiling, degrees, floor } from "./numbers.js";

/** The slider of the intensity ends at this multiple of the light's initial intensity. */
const HEADROOM = 2.5;

export class LightPanel {
  #demo;
  #light;
  #controls = new Map();
  #dials;
  /** The last refusal, and why the requested number format can't hold the light. */
  #refusal = "";
  #objection = "";

  /** The panel's element. */
  element;
  /** Called when the light has changed. */
  onchange = () => {};
  /** Called when there is a new message: a change, a refusal, or the end of one. */
  ontell = () => {};

  constructor(demo, light) {
    this.#demo = demo;
    this.#light = light;
    this.element = document.getElementById("panel").content.firstElementChild.cloneNode(true);
    this.#name();
    listFixtures(this.#control("fixture"));
    this.#dials = this.#join();
    this.#show();
  }

  /** The current message, if any. */
  get error() {
    return this.#refusal || this.#objection;
  }

  /** Shows why a requested number format can't hold this light; empty if it can. */
  object(objection) {
    this.#objection = objection;
    this.#tell();
  }

  /** Shows the state of the light and discards rejected input. */
  refresh() {
    this.#refuse(undefined, "");
    this.#show();
  }

  /** Shows the state of the light, except on the control that the change comes from. */
  #show(source) {
    const state = this.#demo.light(this.#light);
    const { beam, field, zoom, intensity } = this.#dials;
    beam.range(ceiling(state.narrowestBeam), floor(state.widestBeam));
    beam.show(state.beam, source);
    field.range(ceiling(state.narrowestField), floor(state.widestField));
    field.show(state.field, source);
    intensity.show(state.intensity, source);
    this.#showFixture(state);
    if (state.zoom !== undefined) zoom.show(state.zoom, source);
    this.#control("outer").textContent = degrees(state.outer);
    this.#control("edge").value = state.edge;
    this.#control("color").value = state.color;
    this.#control("on").checked = state.on;
    this.#control("reading").value = state.reading;
    state.free();
  }

  /** Sets the ids of the template's elements and connects the labels. */
  #name() {
    for (const element of this.element.querySelectorAll("[data-id]")) {
      this.#controls.set(element.dataset.id, element);
      element.id = `light-${this.#light}-${element.dataset.id}`;
    }
    for (const label of this.element.querySelectorAll("[data-for]")) {
      label.htmlFor = `light-${this.#light}-${label.dataset.for}`;
    }
  }

  #control(name) {
    return this.#controls.get(name);
  }

  /** Connects the controls to the setters of the module; returns the dials. */
  #join() {
    const demo = this.#demo;
    const light = this.#light;
    const dial = (slider, number, set) =>
      new Dial(
        this.#control(slider),
        this.#control(number),
        (value, control) => this.#set(control, () => set(value)),
        (control, source) => this.#leave(control, source),
      );
    const simple = (name, set) => {
      const control = this.#control(name);
      control.addEventListener("input", () => this.#set(control, () => set(control)));
    };
    simple("fixture", (select) => demo.setFixture(light, select.value));
    simple("reading", (select) => demo.setReading(light, select.value));
    simple("edge", (select) => demo.setEdge(light, select.value));
    simple("color", (picker) => demo.setColor(light, picker.value));
    simple("on", (box) => demo.setOn(light, box.checked));
    const intensity = dial("intensity-slider", "intensity", (value) => demo.setIntensity(light, value));
    const state = demo.light(light);
    intensity.range(0, Math.ceil(HEADROOM * state.intensity));
    state.free();
    return {
      beam: dial("beam", "beam-number", (value) => demo.setBeam(light, value)),
      field: dial("field", "field-number", (value) => demo.setField(light, value)),
      zoom: dial("zoom", "zoom-number", (value) => demo.setZoom(light, value)),
      intensity,
    };
  }

  /** Sets a value. A refusal changes only the message; an accepted value clears it. */
  #set(control, set) {
    try {
      set();
    } catch (refusal) {
      // The module refuses with a string; anything else is a bug in the page.
      if (typeof refusal !== "string") throw refusal;
      this.#refuse(control, refusal);
      return;
    }
    this.#refuse(control, "");
    this.#show(control);
    this.onchange();
  }

  /**
   * Called when a number field is empty or loses focus: clears its error and shows the current
   * value, unless it is edited.
   */
  #leave(control, source) {
    if (control.hasAttribute("aria-invalid")) this.#refuse(control, "");
    this.#show(source);
  }

  #refuse(control, refusal) {
    this.element.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid");
    if (refusal) {
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-errormessage", this.#control("error").id);
      // The message is shown under its control.
      control.closest(".row").after(this.#control("error"));
    } else {
      // The objection of a number format belongs to no control.
      this.element.append(this.#control("error"));
    }
    this.#refusal = refusal;
    this.#tell();
  }

  #tell() {
    this.#control("error").textContent = this.error;
    this.ontell();
  }

  #showFixture(state) {
    const fixture = findFixture(state.fixture);
    this.#control("fixture").value = state.fixture;
    this.#control("published").hidden = !fixture;
    this.#control("zoom-row").hidden = !fixture || fixture.narrow === fixture.wide;
    if (!fixture) return;
    this.#control("angle").textContent = fixture.angle;
    this.#control("flux").textContent = fixture.flux;
    this.#dials.zoom.range(fixture.narrow, fixture.wide);
  }
}
