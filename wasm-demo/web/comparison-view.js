// The comparison: two forms of one beam, each beside what f64 makes of it.
import { Comparison } from "./pkg/wasm_demo.js";
import { remember } from "./address.js";
import { Divider } from "./divider.js";
import { ErrorScale } from "./error-scale.js";
import { hasFailed } from "./failure.js";
import { HalfAngle } from "./half-angle.js";
import { Ledger } from "./ledger.js";
import { degrees } from "./numbers.js";
import { plain } from "./plain.js";
import { PriceList } from "./price-list.js";

/** Pixels a side: enough to see the rings of a beam that has lost its bits. */
const SIZE = 400;

const SIDES = [0, 1];
const on = (name, side) => document.getElementById(`${name}-${side}`);

/** A distance in metres, in the unit that people would use. */
function far(metres) {
  if (metres < 1) return `${Math.round(100 * metres)} cm`;
  return metres < 1000 ? `${Number(metres.toPrecision(3))} m` : `${Number((metres / 1000).toPrecision(3))} km`;
}

export class ComparisonView {
  #comparison;
  #forms;
  #halfAngle;
  #scale;
  #ledger;
  #frame = 0;
  /** What the address asked for in vain, for each side. */
  #unknown = ["", ""];

  /** How many times the pictures have been drawn. */
  drawn = 0;

  /** Opens the comparison; the list of prices is loaded with it. */
  static async open() {
    return new ComparisonView(await PriceList.load());
  }

  constructor(prices) {
    const canvases = SIDES.flatMap((side) => [on("picture", side), on("errors", side)]);
    this.#comparison = new Comparison(...canvases, SIZE);
    this.#forms = new Map(Comparison.forms().map((form) => [form.name, plain(form)]));
    this.#halfAngle = new HalfAngle([Comparison.narrowest(), Comparison.widest()].map(exact), (value) => {
      this.#comparison.setHalfAngle(value);
      this.#request();
    });
    this.#scale = new ErrorScale(this.#comparison, Comparison.scales());
    this.#scale.onchange = () => this.#request();
    this.#ledger = new Ledger(this.#comparison, this.#forms, prices);
    new Divider(document.getElementById("comparison"));
    for (const side of SIDES) this.#joinSide(side);
  }

  /** Shows what the address asks for, such as `left=f32&right=fx16&half=0.6`; what is refused is told. */
  show(query) {
    for (const [side, name] of ["left", "right"].entries()) this.#ask(side, query.get(name));
    this.#halfAngle.show(exact(this.#comparison.halfAngle));
    const half = query.get("half");
    if (half !== null) this.#halfAngle.take(half.trim() === "" ? NaN : Number(half));
    this.#draw();
  }

  /** The view is no longer seen. */
  hide() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#ledger.stop();
  }

  /** What is known of both sides: plain objects. */
  get sides() {
    return SIDES.map((side) => plain(this.#comparison.side(side)));
  }

  /** Asks for a form by the name that stands in the address, if there is one. */
  #ask(side, name) {
    this.#unknown[side] = "";
    if (name === null) return;
    try {
      this.#comparison.setForm(side, name);
    } catch (refusal) {
      if (typeof refusal !== "string") throw refusal;
      this.#unknown[side] = refusal;
    }
  }

  /** Settled when the pictures shown have been timed. */
  get measured() {
    return this.#ledger.measured;
  }

  #joinSide(side) {
    const select = on("form", side);
    for (const { name, label } of this.#forms.values()) select.add(new Option(label, name));
    select.addEventListener("input", () => {
      this.#ask(side, select.value);
      this.#request();
    });
    on("widen", side).addEventListener("click", () => {
      this.#halfAngle.take(exact(this.sides[side].narrowest));
      // The button is gone, and with it the focus that it had.
      document.getElementById("half-angle").focus();
    });
  }

  /** Draws with the next frame of the browser, however often it is asked for. */
  #request() {
    if (this.#frame === 0 && !hasFailed()) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#comparison.draw();
    const states = this.sides;
    for (const [side, state] of states.entries()) this.#tell(side, state);
    const { beam, field, distance } = this.#comparison;
    document.getElementById("beam-note").textContent =
      `Full angles: beam ${degrees(beam)}, field ${degrees(field)}. The wall is ${far(distance)} away, ` +
      "so that the spot on it keeps its radius of one metre.";
    this.#scale.show();
    this.#ledger.show(states);
    this.#remember(states);
    this.drawn += 1;
  }

  #tell(side, state) {
    const { label } = this.#forms.get(state.form);
    const refused = state.refusal !== undefined;
    on("form", side).value = state.form;
    on("form", side).setAttribute("aria-invalid", refused);
    on("refusal", side).textContent = this.#unknown[side] || (state.refusal ?? "");
    on("refusal-badge", side).hidden = on("refusal", side).textContent === "";
    on("widen", side).hidden = state.narrowest === undefined;
    if (state.narrowest !== undefined) on("widen", side).textContent = `Widen to ${exact(state.narrowest)}°`;
    for (const half of document.querySelectorAll(`.half[data-side="${side}"]`)) {
      half.classList.toggle("is-refused", refused);
      half.querySelector(".missing").hidden = !refused;
    }
    on("picture", side).setAttribute("aria-label", `The beam in ${label}`);
    on("errors", side).setAttribute("aria-label", `What ${label} differs from f64 by`);
    this.#ring(side, state);
  }

  /** Marks the pixel of the largest error. */
  #ring(side, { largest, place }) {
    const middle = (index) => `${(100 * (index + 0.5)) / SIZE}%`;
    const ring = on("spot", side);
    ring.hidden = !(largest > 0);
    ring.style.left = middle(place % SIZE);
    ring.style.top = middle(Math.floor(place / SIZE));
  }

  /** Keeps the address in step, so that it can be passed on. */
  #remember([left, right]) {
    const half = exact(this.#comparison.halfAngle);
    const query = new URLSearchParams({ left: left.form, right: right.form, half });
    remember("compare", query);
  }
}

/** An f32 as the decimal fraction that it was meant to be. */
const exact = (value) => Number(value.toPrecision(7));
