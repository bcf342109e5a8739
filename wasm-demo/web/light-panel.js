// The controls of the selected light. They show the state from the module and pass on the visitor's
// settings.
import { Stage } from "./pkg/wasm_demo.js";
import { Dial, joinNumber } from "./dial.js";
import { copyOf, element as find, find as findIn } from "./elements.js";
import { refusalOf } from "./failure.js";
import { findFixture, listFixtures } from "./fixture-list.js";
import { degrees, tidy, whole } from "./numbers.js";
import { plain } from "./plain.js";

/** @typedef {import("./plain.js").Plain<import("./pkg/wasm_demo.js").LightState>} Light */
/** @typedef {import("./pkg/wasm_demo.js").ModelState} Model */

/** @param {string} name */
const element = (name) => find(`light-${name}`);
/** @param {string} name */
const input = (name) => find(`light-${name}`, HTMLInputElement);
/** @param {string} name */
const select = (name) => find(`light-${name}`, HTMLSelectElement);

/** The edges that are offered at once; the others follow after a choice of more. */
const USUAL = ["soft", "soft-pair", "hard", "smooth"];

/** The units of the dials, for people who hear their values. */
const UNITS = { beam: "°", field: "°", zoom: "°", intensity: "", kelvin: " K" };

/**
 * The fields of a position and of an aim.
 * @type {Record<"position" | "aim", string[]>}
 */
const PLACES = { position: ["x", "y", "z"], aim: ["aim-x", "aim-y", "aim-z"] };

export class LightPanel {
  #stage;
  #light = 0;
  #panel = find("panel");
  #error = element("error");
  #dials;
  /** @type {Record<"law" | "edge", Model[]>} */
  #models = { law: Stage.laws(), edge: Stage.edges() };
  /**
   * The model whose numbers are shown, and their dials.
   * @type {Record<"law" | "edge", { name: string, dials: Dial[] }>}
   */
  #numbers = { law: { name: "", dials: [] }, edge: { name: "", dials: [] } };
  /**
   * The angle that was typed last, and the light as it was then.
   * @type {{ name: string, light: number, angles: string } | undefined}
   */
  #typed;

  /** Called when the light has changed, with the control that the change comes from. */
  onchange = /** @type {(source: Element) => void} */ (() => {});
  /** Called with a change of the list of lights. */
  onlist = /** @type {(act: () => void) => void} */ (() => {});

  /** @param {Stage} stage */
  constructor(stage) {
    this.#stage = stage;
    const count = listFixtures(element("fixtures"));
    input("fixture").placeholder = `Search ${count} fixtures`;
    element("law").append(...this.#models.law.map(option));
    element("edge").append(...this.#models.edge.filter(({ name }) => USUAL.includes(name)).map(option), new Option("more edges …", "more"));
    const [beam, field] = [this.#dial("beam"), this.#dial("field")];
    const [zoom, intensity, kelvin] = [this.#dial("zoom"), this.#dial("intensity"), this.#dial("kelvin")];
    this.#dials = { beam, field, zoom, intensity, kelvin };
    const choices = { kind: select, law: select, fixture: input, reading: select, edge: select, color: input };
    for (const [name, kind] of Object.entries(choices)) {
      const control = kind(name);
      control.addEventListener("input", () => {
        // What is not yet the name of a fixture is a search.
        if (name === "fixture" && control.value !== "" && !findFixture(control.value)) return;
        if (control.value === "more") return this.#unfold();
        this.#set(control, () => stage.setChoice(this.#light, name, control.value));
      });
    }
    element("fixture").addEventListener("change", () => this.show(this.#light));
    this.#joinPlace("position", (place) => stage.placeLight(this.#light, ...place));
    this.#joinPlace("aim", (place) => stage.aimLight(this.#light, ...place));
    element("back").addEventListener("click", () => this.onlist(() => stage.putBack(this.#light)));
    element("expose").addEventListener("click", () => this.onlist(() => stage.exposeFor(this.#light)));
    element("copy").addEventListener("click", () => this.onlist(() => stage.copyLight(this.#light)));
    element("remove").addEventListener("click", () => {
      this.onlist(() => stage.removeLight(this.#light));
      // The panel of the last light is gone, and the button with it.
      if (stage.lightCount === 0) element("add").focus();
    });
  }

  /**
   * Shows a light, except on the control that a change comes from.
   * @param {number} light
   * @param {Element} [source]
   */
  show(light, source) {
    if (light !== this.#light) this.#refuse(undefined, "");
    this.#light = light;
    this.#panel.hidden = this.#stage.lightCount === 0;
    if (this.#panel.hidden) return;
    const state = plain(this.#stage.light(light));
    find("panel-title").textContent = `${light + 1} ${state.name}`;
    element("cone").hidden = !state.isSpot;
    element("curve").hidden = !state.isSpot;
    for (const part of [element("edge"), element("edge").previousElementSibling]) {
      part?.toggleAttribute("hidden", !state.isSpot);
    }
    this.#showDials(state, source);
    this.#showPlaces(state, source);
    element("photometry").textContent = photometry(state, this.#stage.fullScale);
    element("expose").hidden = !((state.lux ?? 0) > 0);
    element("own-edge").textContent = `default: ${state.ownEdge}`;
    for (const name of /** @type {const} */ (["kind", "law", "edge"])) select(name).value = state[name];
    if (select("edge").value !== state.edge) this.#unfold();
    input("color").value = state.color;
  }

  /** Offers all edges. The one in force stays chosen. */
  #unfold() {
    const edge = select("edge");
    findIn(edge, "[value=more]").replaceWith(...this.#models.edge.filter(({ name }) => !USUAL.includes(name)).map(option));
    edge.value = plain(this.#stage.light(this.#light)).edge;
  }

  /**
   * @param {Light} state
   * @param {Element} [source]
   */
  #showDials(state, source) {
    const { beam, field, zoom, intensity, kelvin } = this.#dials;
    const fixture = findFixture(state.fixture);
    const ends = plain(this.#stage.dialEnds(this.#light));
    for (const name of /** @type {const} */ (["beam", "field", "zoom", "intensity", "kelvin"])) {
      const [least, most] = ends[name];
      if (most !== undefined) this.#dials[name].range(least, most, UNITS[name]);
    }
    // A directional light has no distance.
    select("law").disabled = state.position.length === 0;
    this.#showNumbers("law", select("law").disabled ? "" : state.law, state.lawNumbers, ends.law, source);
    this.#showNumbers("edge", state.isSpot ? state.edge : "", state.edgeNumbers, ends.edge, source);
    intensity.show(Number(state.intensity.toPrecision(4)), source);
    element("unit").textContent = state.unit;
    kelvin.show(state.kelvin ?? NaN, source);
    if (!state.isSpot) return;
    beam.show(state.beam, source);
    field.show(state.field, source);
    element("outer").textContent = degrees(state.outer);
    if (source !== input("fixture")) input("fixture").value = state.fixture;
    element("published").hidden = !fixture;
    element("zoom-row").hidden = !fixture || fixture.narrow === fixture.wide;
    if (!fixture) return;
    element("angle").textContent = fixture.angle;
    select("reading").value = state.reading;
    zoom.show(state.zoom ?? fixture.wide, source);
  }

  /**
   * Shows where the light is and where it aims.
   * @param {Light} state
   * @param {Element} [source]
   */
  #showPlaces(state, source) {
    element("places").hidden = state.position.length === 0;
    element("aim-row").hidden = !state.isSpot;
    for (const place of /** @type {const} */ (["position", "aim"])) {
      for (const [i, name] of PLACES[place].entries()) {
        const field = input(name);
        if (field !== source) field.value = state[place].length > 0 ? millimetres(state[place][i]) : "";
      }
    }
    element("way").textContent = way(state);
    element("back").hidden = !state.moved;
  }

  /**
   * Joins the fields of a place; `set` gets its three numbers.
   * @param {"position" | "aim"} place
   * @param {(place: [number, number, number]) => void} set
   */
  #joinPlace(place, set) {
    const fields = PLACES[place].map(input);
    for (const [i, field] of fields.entries()) {
      /** @type {(value: number) => void} */
      const change = (value) => {
        const [x, y, z] = plain(this.#stage.light(this.#light))[place].with(i, value);
        set([x, y, z]);
      };
      joinNumber(field, (value) => this.#set(field, () => change(value)), (source, isSet) => this.#leave(field, source, isSet));
    }
  }

  /**
   * Sets a number of the light, for a control elsewhere.
   * @param {string} name
   * @param {number} value
   * @param {Element} control
   */
  setNumber(name, value, control) {
    this.#set(control, () => this.#stage.setNumber(this.#light, name, value));
  }

  /**
   * Shows the numbers of the chosen law or edge; none for one that has none.
   * @param {"law" | "edge"} choice
   * @param {string} name
   * @param {ArrayLike<number>} values
   * @param {ArrayLike<number>} ends of each dial, one after the other
   * @param {Element} [source]
   */
  #showNumbers(choice, name, values, ends, source) {
    const { numbers } = this.#models[choice].find((model) => model.name === name) ?? { numbers: [] };
    if (this.#numbers[choice].name !== name) {
      const rows = element(`${choice}-numbers`);
      // A refusal stands under its control, and ends with it.
      if (rows.contains(this.#error)) {
        rows.after(this.#error);
        this.#refuse(undefined, "");
      }
      rows.replaceChildren();
      const dials = numbers.map((number, place) => this.#numberOf(choice, number, `${choice}-${place}`));
      this.#numbers[choice] = { name, dials };
    }
    element(`${choice}-numbers`).hidden = numbers.length === 0;
    for (const [place, dial] of this.#numbers[choice].dials.entries()) {
      const { unit, isLogarithmic, isWhole } = numbers[place];
      dial.range(ends[2 * place], ends[2 * place + 1], unit, isLogarithmic, isWhole);
      dial.show(values[place], source);
    }
  }

  /**
   * Adds the dial of a number of a law or an edge.
   * @param {"law" | "edge"} choice
   * @param {import("./pkg/wasm_demo.js").NumberState} number
   * @param {string} name
   */
  #numberOf(choice, { label, unit }, name) {
    const row = copyOf("number");
    const [slider, field] = row.querySelectorAll("input");
    [slider.id, field.id, field.ariaLabel] = [`light-${name}`, `light-${name}-number`, label + unit];
    Object.assign(findIn(row, "label"), { textContent: label, htmlFor: slider.id });
    findIn(row, "i").textContent = unit;
    element(`${choice}-numbers`).append(row);
    return this.#dial(name);
  }

  /** @param {string} name */
  #dial(name) {
    /** @type {(value: number, control: HTMLInputElement) => void} */
    const set = (value, control) =>
      this.#set(control, () => {
        if (control.type === "number" && (name === "beam" || name === "field")) return this.#type(name, value);
        this.#stage.setNumber(this.#light, name, value);
        return "";
      });
    /** @type {(control: HTMLInputElement, source: HTMLInputElement | undefined, isSet: boolean) => void} */
    const leave = (control, source, isSet) => this.#leave(control, source, isSet);
    return new Dial(input(name), input(`${name}-number`), set, leave);
  }

  /**
   * Sets a typed angle. It keeps the other one, if that was typed just before, or else the edge gives it. Returns what
   * is said if no light has both: the pair is then the nearest.
   * @param {"beam" | "field"} name
   * @param {number} value
   */
  #type(name, value) {
    const angles = () => {
      const { beam, field, edge, reach } = plain(this.#stage.light(this.#light));
      return { beam, field, reach, text: [beam, field, edge].join() };
    };
    const [before, typed] = [angles(), this.#typed];
    const other = name === "beam" ? "field" : "beam";
    const isPair = typed?.light === this.#light && typed.name === other && typed.angles === before.text;
    this.#stage.setNumber(this.#light, isPair ? `pair-${name}` : name, value);
    const after = angles();
    this.#typed = { name, light: this.#light, angles: after.text };
    if (!isPair || Math.abs(after[other] / before[other] - 1) < 1e-3) return "";
    const [least, most] = after.reach.slice(other === "beam" ? 0 : 2);
    return (
      `${other} angle = ${tidy(before[other])}: expected ${tidy(least)} to ${tidy(most)} degrees beside a ${name} angle of ${tidy(value)}. ` +
      `Drawn is the nearest pair, ${degrees(after.beam)} and ${degrees(after.field)}.`
    );
  }

  /**
   * Sets a value. A refusal changes only the message; an accepted value clears it, or has what `set` returns.
   * @param {Element} control
   * @param {() => string | void} set
   */
  #set(control, set) {
    let told;
    const refusal = refusalOf(() => (told = set()));
    this.#refuse(control, refusal);
    if (refusal !== "") return;
    this.onchange(control);
    this.#tell(control, told || "");
  }

  /**
   * Called when a number field is empty or loses focus: clears its error and shows the current
   * value, unless it is edited. A refusal that nobody has read yet stays.
   * @param {HTMLInputElement} control
   * @param {HTMLInputElement | undefined} source
   * @param {boolean} isSet
   */
  #leave(control, source, isSet) {
    if (isSet) control.removeAttribute("aria-invalid");
    else if (control.hasAttribute("aria-invalid")) this.#refuse(control, "");
    this.show(this.#light, source);
  }

  /**
   * @param {Element | undefined} control
   * @param {string} refusal
   */
  #refuse(control, refusal) {
    this.#panel.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid");
    if (control && refusal) {
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-errormessage", this.#error.id);
    }
    this.#tell(control, refusal);
  }

  /**
   * Shows a message under its control.
   * @param {Element | undefined} control
   * @param {string} text
   */
  #tell(control, text) {
    if (text) control?.closest(".row, figure")?.after(this.#error);
    this.#error.textContent = text;
  }
}

/** @param {Model} model to choose */
const option = ({ name }) => new Option(name.replaceAll("-", " "), name);

/**
 * The flux of a light and what arrives where it aims, in words.
 * @param {Light} light
 * @param {number} fullScale
 */
function photometry({ lumens, lux, throw: distance, unit }, fullScale) {
  const flux = lumens === undefined ? [] : [`${amount(lumens)} lm`];
  const arriving = lux === undefined || distance === undefined || unit !== "cd" ? [] : [`${amount(lux)} lx at ${tidy(distance)} m`];
  const shown = lux === undefined ? [] : [`${amount(lux / fullScale)} times full scale: a white surface is shown as white from ${amount(fullScale)} lx on`];
  const parts = [...flux, ...arriving, ...shown];
  return parts.length > 0 ? `${parts.join(", ")}.` : "";
}

/**
 * Metres, rounded to millimetres.
 * @param {number} value
 */
const millimetres = (value) => String(Number(value.toFixed(3)) + 0);

/**
 * Three significant digits.
 * @param {number} value
 */
const amount = (value) => (value < 100 ? String(tidy(Number(value.toPrecision(3)))) : whole(Number(value.toPrecision(3))));

/**
 * Who moves the light, in words.
 * @param {Light} light
 */
function way({ sweeps, moved, aim }) {
  if (sweeps) return "The scene moves the aim. An aim of your own ends that.";
  if (moved) return "Moved by you.";
  return aim.length > 0 ? "As the scene has it: drag it in the picture." : "";
}
