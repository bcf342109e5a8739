// The controls of one light. They show what the module says of the light, and pass on what the visitor sets.
import { Dial } from "./dial.js";
import { findFixture, listFixtures } from "./fixture-list.js";
import { ceiling, degrees, floor } from "./numbers.js";

/** The slider of the intensity goes up to so many times what the light had at first. */
const HEADROOM = 2.5;

export class LightPanel {
  #demo;
  #light;
  #controls = new Map();
  #dials;
  /** What was refused, and what the wanted number format has against the light. */
  #refusal = "";
  #objection = "";

  /** The panel's element. */
  element;
  /** Called when the light has changed. */
  onchange = () => {};
  /** Called when there is something new to say: a change, a refusal, or the end of one. */
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

  /** What is wrong with this light, if anything. */
  get error() {
    return this.#refusal || this.#objection;
  }

  /** Shows what a number format that was asked for has against this light; empty for nothing. */
  object(objection) {
    this.#objection = objection;
    this.#tell();
  }

  /** Shows the light as it is, and forgets what was typed in vain. */
  refresh() {
    this.#refuse(undefined, "");
    this.#show();
  }

  /** Shows the light as it is, except on the control that the change comes from. */
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

  /** Gives the elements of the template their ids, and the labels their elements. */
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

  /** Joins the controls to the setters of the module; answers the dials. */
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

  /** Sets something. A refusal changes nothing but the message; a value that is taken ends it. */
  #set(control, set) {
    try {
      set();
    } catch (refusal) {
      // The module refuses with a string; anything else is a fault of ours.
      if (typeof refusal !== "string") throw refusal;
      this.#refuse(control, refusal);
      return;
    }
    this.#refuse(control, "");
    this.#show(control);
    this.onchange();
  }

  /** A number field is empty or left: it is not in error any more, and shows the value in force unless it is edited. */
  #leave(control, source) {
    if (control.hasAttribute("aria-invalid")) this.#refuse(control, "");
    this.#show(source);
  }

  #refuse(control, refusal) {
    this.element.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid");
    if (refusal) {
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-errormessage", this.#control("error").id);
      // The message stands under the control that it is about.
      control.closest(".row").after(this.#control("error"));
    } else {
      // What a number format has against the light is about no control of it.
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
