// The museum: faulty spotlights of other projects, beside the exact light and the crate's.
import { Museum } from "./pkg/comparison.js";
import { remember } from "./address.js";
import { start } from "./comparison-module.js";
import { aside, hasFailed } from "./failure.js";
import { colours, tidy } from "./numbers.js";
import { plain } from "./plain.js";
import { Slider } from "./slider.js";

/** Pixels on a side of a picture; fewer where two stand beside each other on a telephone. */
const SIZE = { wide: 200, narrow: 160 };
const THUMBNAIL = 48;

const SIDES = [0, 1];
const element = (name) => document.getElementById(`exhibit-${name}`);
const on = (name, side) => element(`${name}-${side}`);

/** Formats an error in linear codes. */
function codes(value) {
  if (value < 0.001) return "under 0.001 codes";
  const rounded = value < 10 ? Number(value.toPrecision(2)) : Math.round(value);
  return `${rounded.toLocaleString("en")} ${rounded === 1 ? "code" : "codes"}`;
}

/** Loads the style sheet of this view, which the others do not need. */
function styled() {
  const sheet = document.createElement("link");
  sheet.rel = "stylesheet";
  sheet.href = "museum.css";
  return new Promise((resolve) => {
    sheet.addEventListener("load", resolve);
    // Without its style the museum is plain and still right.
    sheet.addEventListener("error", resolve);
    document.head.append(sheet);
  });
}

export class MuseumView {
  #exhibits = new Map(Museum.exhibits().map((exhibit) => [exhibit.name, plain(exhibit)]));
  #size = innerWidth < 560 ? SIZE.narrow : SIZE.wide;
  #museum;
  #slider;
  #frame = 0;

  /** How many times the pictures have been drawn. */
  drawn = 0;

  static async open() {
    await Promise.all([start(), styled()]);
    return new MuseumView();
  }

  constructor() {
    const canvases = SIDES.flatMap((side) => [on("picture", side), on("errors", side)]);
    this.#museum = new Museum(...canvases, this.#size);
    this.#slider = new Slider(element("value"), element("number"), (value, source) => this.#set(value, source));
    for (const exhibit of this.#exhibits.values()) this.#list(exhibit);
    for (const name of ["start", "agrees"]) {
      element(name).addEventListener("click", () => this.#set(Number(element(name).value)));
    }
    element("legend").style.background = `linear-gradient(90deg, ${colours(this.#museum.palette()).join()})`;
    element("undefined").style.background = colours(Museum.undefined())[0];
    this.#drawThumbnails([...this.#exhibits.keys()]);
  }

  /** Applies the address, such as `exhibit=gltf&at=2`. Refusals are shown. */
  show(text) {
    const query = new URLSearchParams(text);
    const name = query.get("exhibit") ?? this.#museum.exhibit;
    this.#tell("");
    this.#try(() => this.#museum.open(name));
    this.#showExhibit();
    const at = query.get("at");
    if (at === null) this.#draw();
    else this.#set(at.trim() === "" ? NaN : Number(at));
    if (this.drawn === 0) this.#draw();
  }

  /** Called when the view is hidden. */
  hide() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  /** The state for tests: the exhibit, its control and the errors of both pictures. */
  get state() {
    const { exhibit, value, format, scale } = this.#museum;
    return { exhibit, value: exact(value), format, scale, sides: SIDES.map((side) => plain(this.#museum.side(side))) };
  }

  /** The names of the exhibits. */
  get names() {
    return [...this.#exhibits.keys()];
  }

  #list({ name, label }) {
    const item = document.getElementById("exhibit").content.firstElementChild.cloneNode(true);
    const input = item.querySelector("input");
    input.id = `exhibit-of-${name}`;
    input.value = name;
    item.querySelector("span").textContent = label;
    input.addEventListener("input", () => this.show(new URLSearchParams({ exhibit: name })));
    element("list").append(item);
  }

  /** Draws one small picture with each frame of the browser. */
  #drawThumbnails([name, ...rest]) {
    if (name === undefined || hasFailed()) return;
    aside(() => {
      const canvas = document.getElementById(`exhibit-of-${name}`).parentElement.querySelector("canvas");
      canvas.width = canvas.height = THUMBNAIL;
      const image = new ImageData(Museum.thumbnail(name, THUMBNAIL), THUMBNAIL, THUMBNAIL);
      canvas.getContext("2d").putImageData(image, 0, 0);
    });
    requestAnimationFrame(() => this.#drawThumbnails(rest));
  }

  /** Sets the control. A refusal is shown and changes nothing else. */
  #set(value, source) {
    this.#tell("");
    if (!this.#try(() => this.#museum.setValue(value))) return;
    this.#slider.show(exact(this.#museum.value), source);
    if (this.#frame === 0 && !hasFailed()) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #try(act) {
    try {
      act();
      return true;
    } catch (refusal) {
      if (typeof refusal !== "string") throw refusal;
      this.#tell(refusal);
      return false;
    }
  }

  #tell(refusal) {
    element("error").textContent = refusal;
    element("number").setAttribute("aria-invalid", refusal !== "");
  }

  /** Shows what does not change with the control. */
  #showExhibit() {
    const exhibit = this.#exhibits.get(this.#museum.exhibit);
    const chosen = document.getElementById(`exhibit-of-${exhibit.name}`);
    chosen.checked = true;
    // On narrow screens the list is a row that scrolls.
    element("list").scrollLeft = chosen.parentElement.offsetLeft - THUMBNAIL;
    for (const name of ["title", "code", "cause", "noBetter", "project", "file", "version", "licence", "thread"]) {
      element(name).textContent = exhibit[name];
    }
    element("thread").parentElement.hidden = exhibit.thread === "";
    element("control").textContent = exhibit.control;
    element("unit").textContent = exhibit.unit;
    element("number").setAttribute("aria-label", `${exhibit.control}${exhibit.unit && `, ${exhibit.unit}`}`);
    this.#slider.range(exact(exhibit.least), exact(exhibit.most), exhibit.isLogarithmic, exhibit.unit);
    this.#slider.show(exact(this.#museum.value));
    element("start").value = exact(exhibit.start);
    element("start").textContent = `Named case: ${tidy(exact(exhibit.start))}${exhibit.unit}`;
    element("agrees").hidden = exhibit.agreesAt === undefined;
    if (exhibit.agreesAt === undefined) return;
    element("agrees").value = exact(exhibit.agreesAt);
    element("agrees").textContent = `Both right: ${tidy(exact(exhibit.agreesAt))}${exhibit.unit}`;
  }

  #draw() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#museum.draw();
    const { exhibit, value, format, scale, sides } = this.state;
    const { label } = this.#exhibits.get(exhibit);
    for (const [side, { largest, undefined: lost, place }] of sides.entries()) {
      const share = Number(((100 * lost) / this.#size ** 2).toPrecision(2));
      on("largest", side).textContent = lost === 0 ? codes(largest) : `NaN, ${share} % of the pixels`;
      on("picture", side).setAttribute("aria-label", side === 0 ? `${label}, as published` : "The same beam by luminaire");
      on("errors", side).setAttribute("aria-label", `Largest error: ${on("largest", side).textContent}`);
      this.#ring(side, largest, place);
    }
    element("format").textContent = format;
    element("end").textContent = `${codes(scale)}${sides[0].largest > scale ? " or more" : ""}`;
    element("lost").hidden = sides.every((side) => side.undefined === 0);
    remember("museum", () => new URLSearchParams({ exhibit, at: value }));
    this.drawn += 1;
  }

  /** Marks the pixel of the largest error. */
  #ring(side, largest, place) {
    const middle = (index) => `${(100 * (index + 0.5)) / this.#size}%`;
    const ring = on("ring", side);
    ring.hidden = !(largest > 0.5);
    ring.style.left = middle(place % this.#size);
    ring.style.top = middle(Math.floor(place / this.#size));
  }
}

/** Rounds an f32 to 7 significant digits, which restores the decimal fraction that was set. */
const exact = (value) => Number(value.toPrecision(7));
