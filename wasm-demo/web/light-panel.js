// The controls of the selected light. They show the state from the module and pass on the visitor's
// settings.
import { Dial } from "./dial.js";
import { findFixture, listFixtures } from "./fixture-list.js";
import { degrees } from "./numbers.js";
import { plain } from "./plain.js";

const element = (name) => document.getElementById(`light-${name}`);

/** The ends of the slider of the intensity, as multiples of the light's own intensity. */
const INTENSITIES = [0.01, 10];

/** Least angle of the zoom's slider, as a share of the largest. */
const LEAST_ZOOM = 0.01;

export class LightPanel {
  #stage;
  #light = 0;
  #panel = document.getElementById("panel");
  #error = element("error");
  #dials;

  /** Called when the light has changed, with the control that the change comes from. */
  onchange = () => {};
  /** Called with a change of the list of lights. */
  onlist = () => {};

  constructor(stage) {
    this.#stage = stage;
    listFixtures(element("fixture"));
    const dial = (name) => [name, this.#dial(name)];
    this.#dials = Object.fromEntries(["beam", "field", "zoom", "intensity"].map(dial));
    for (const name of ["fixture", "reading", "edge", "color"]) {
      const control = element(name);
      control.addEventListener("input", () => this.#set(control, () => stage.setChoice(this.#light, name, control.value)));
    }
    element("copy").addEventListener("click", () => this.onlist(() => stage.copyLight(this.#light)));
    element("remove").addEventListener("click", () => this.onlist(() => stage.removeLight(this.#light)));
  }

  /** Shows a light, except on the control that a change comes from. */
  show(light, source) {
    if (light !== this.#light) this.#refuse(undefined, "");
    this.#light = light;
    this.#panel.hidden = this.#stage.lightCount === 0;
    if (this.#panel.hidden) return;
    const state = plain(this.#stage.light(light));
    document.getElementById("panel-title").textContent = `${light + 1} ${state.name}`;
    element("cone").hidden = !state.isSpot;
    element("curve").hidden = !state.isSpot;
    for (const label of [element("edge"), element("edge").previousElementSibling]) label.hidden = !state.isSpot;
    this.#showDials(state, source);
    element("own-edge").textContent = `its own: ${state.ownEdge}`;
    element("edge").value = state.edge;
    element("color").value = state.color;
  }

  #showDials(state, source) {
    const { beam, field, zoom, intensity } = this.#dials;
    intensity.range(...INTENSITIES.map((factor) => factor * state.ownIntensity));
    intensity.show(state.intensity, source);
    if (!state.isSpot) return;
    beam.range(state.narrowestBeam, state.widestBeam);
    beam.show(state.beam, source);
    field.range(state.narrowestField, state.widestField);
    field.show(state.field, source);
    element("outer").textContent = degrees(state.outer);
    const fixture = findFixture(state.fixture);
    element("fixture").value = state.fixture;
    element("published").hidden = !fixture;
    element("zoom-row").hidden = !fixture || fixture.narrow === fixture.wide;
    if (!fixture) return;
    element("angle").textContent = fixture.angle;
    element("flux").textContent = fixture.flux;
    element("reading").value = state.reading;
    const narrowest = state.reading === "beam" ? state.narrowestBeam : state.narrowestField;
    zoom.range(Math.max(fixture.narrow, narrowest, LEAST_ZOOM * fixture.wide), fixture.wide);
    zoom.show(state.zoom, source);
  }

  #dial(name) {
    const set = (value, control) => this.#set(control, () => this.#stage.setNumber(this.#light, name, value));
    const leave = (control, source) => this.#leave(control, source);
    return new Dial(element(name), element(`${name}-number`), set, leave, name === "intensity" ? "" : "°");
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
    this.onchange(control);
  }

  /**
   * Called when a number field is empty or loses focus: clears its error and shows the current
   * value, unless it is edited.
   */
  #leave(control, source) {
    if (control.hasAttribute("aria-invalid")) this.#refuse(control, "");
    this.show(this.#light, source);
  }

  #refuse(control, refusal) {
    this.#panel.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid");
    if (refusal) {
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-errormessage", this.#error.id);
      // The message is shown under its control.
      control.closest(".row").after(this.#error);
    }
    this.#error.textContent = refusal;
  }
}
