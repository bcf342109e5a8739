// The class: figures that teach spotlights, drawn by the kernel.
import { Class, initSync } from "./pkg/class.js";
import { remember } from "./address.js";
import { copyTextOf } from "./clipboard.js";
import { element as byId, fetchText, made, row, styled } from "./elements.js";
import { refusalOf } from "./failure.js";
import { Frame } from "./frame.js";
import { compile } from "./module.js";
import { exact } from "./numbers.js";
import { label, line, shape } from "./shapes.js";
import { ToldDial } from "./told-dial.js";

/**
 * What the module says of a parameter, of a figure, and of what is drawn.
 * @typedef {{ name: string, label: string, options?: [string, string][], unit: string, ends: [number, number], isLogarithmic: boolean }} Parameter
 * @typedef {{ name: string, title: string, text: string, formula: string, source: string, question: string, answer: string, which: string, parameters: Parameter[] }} Figure
 * @typedef {{ across: [string, [number, number]], up: [string, number], curves: [string, [number, number][]][], marks: [[number, number], string][] }} Graph
 * @typedef {{ label: string, seen: string, width: number, height: number }} Picture
 * @typedef {{ figure: string, values: Record<string, string>, address: string, pictures: Picture[], graph: Graph | null, numbers: [string, string][], refused: string }} Told
 */

/** The texts of a figure that are shown as they are. */
const TEXTS = /** @type {const} */ (["title", "text", "question", "answer", "source"]);

/** The drawing's box, in the units of the SVG's viewBox. */
const BOX = { left: 42, right: 466, top: 26, bottom: 172 };

/** The classes of the curves, the subject first. */
const KINDS = ["trace", "other power", "other smooth"];

/** @param {string} name */
const element = (name) => byId(`class-${name}`);
const select = () => byId("class-select", HTMLSelectElement);

/**
 * The ticks of an axis: about five round numbers.
 * @param {[number, number]} ends
 */
function ticks([from, to]) {
  const power = 10 ** Math.floor(Math.log10((to - from) / 4));
  const step = power * ([5, 2].find((factor) => (to - from) / (power * factor) >= 4) ?? 1);
  return Array.from({ length: Math.floor(to / step + 1e-9) - Math.ceil(from / step - 1e-9) + 1 }, (_, i) => exact((Math.ceil(from / step - 1e-9) + i) * step));
}

/** @type {(graph: Graph) => SVGElement[]} */
function drawn({ across: [name, [from, to]], up: [level, top], curves, marks }) {
  /** @type {(x: number) => number} */
  const across = (x) => BOX.left + ((BOX.right - BOX.left) * (x - from)) / (to - from);
  /** @type {(y: number) => number} */
  const up = (y) => BOX.bottom + ((BOX.top - BOX.bottom) * y) / top;
  return [
    ...ticks([0, top]).flatMap((y) => [line("level", BOX.left, up(y), BOX.right, up(y)), label("end", BOX.left - 6, up(y) + 4, String(y))]),
    ...ticks([from, to]).flatMap((x) => [line("tick", across(x), BOX.bottom, across(x), BOX.bottom + 5), label("middle", across(x), BOX.bottom + 20, String(x).replace("-", "−"))]),
    label("end", BOX.right, BOX.bottom + 38, name),
    label("", 2, BOX.bottom + 38, `up: ${level}`),
    ...curves.map(([, points], i) => shape("path", { class: KINDS[i], d: `M${points.map(([x, y]) => `${across(x).toFixed(2)} ${up(y).toFixed(2)}`).join("L")}` })).reverse(),
    ...marks.flatMap(([[x, y], text]) => [
      line("drop", across(x), up(y), across(x), BOX.bottom),
      shape("circle", { class: "dot", cx: across(x), cy: up(y), r: 4 }),
      label(`mark ${across(x) > 440 ? "end" : ""}`, across(x) + (across(x) > 440 ? -8 : 8), up(y) - 7, text),
    ]),
  ];
}

export class ClassView {
  #class = new Class();
  /** @type {Figure[]} */
  #figures = JSON.parse(Class.figures());
  #dials;
  /** The parameters that the dials set. */
  #names = ["", ""];
  #frame = new Frame(() => this.#draw());

  /** How many times a figure has been drawn. */
  drawn = 0;

  static async open() {
    const address = new URL("pkg/class_bg.wasm", import.meta.url);
    const [module, page] = await Promise.all([compile(address), fetchText("class.html"), styled("class.css")]);
    initSync({ module });
    byId("class").innerHTML = page;
    return new ClassView();
  }

  constructor() {
    element("list").replaceChildren(...this.#figures.map(({ name, title }, i) =>
      made("li", {}, made("a", { href: `#class?figure=${name}` }, `${i + 1} `, made("span", { textContent: title })))));
    this.#dials = [0, 1].map((i) =>
      new ToldDial({ slider: `class-value-${i}`, number: `class-number-${i}`, error: `class-error-${i}` }, (value) => this.#set(this.#names[i], String(value))));
    select().addEventListener("input", () => {
      this.#dials[0].tell(refusalOf(() => this.#set(select().name, select().value)));
      this.#showControls();
    });
    element("copy").addEventListener("click", () => copyTextOf(element("link"), element("told")));
  }

  /**
   * Applies the address, such as `figure=attenuation&c=1`. Refusals are shown.
   * @param {string} query
   */
  show(query) {
    const refused = this.#class.open(query);
    const figure = this.#figure;
    for (const name of TEXTS) element(name).textContent = figure[name];
    // A letter after ^ is an exponent, and one after _ an index.
    element("formula").replaceChildren(...figure.formula.split(/(?=[\^_])|(?<=[\^_].)/).map((part) => {
      const kind = /** @type {Record<string, "sup" | "sub">} */ ({ "^": "sup", _: "sub" })[part[0]];
      return kind ? made(kind, {}, part.slice(1)) : part;
    }));
    byId("class-details", HTMLDetailsElement).open = false;
    element("told").textContent = "";
    const place = this.#figures.indexOf(figure);
    for (const [i, link] of element("list").querySelectorAll("a").entries()) {
      link.ariaCurrent = i === place ? "true" : null;
    }
    for (const [name, other] of /** @type {const} */ ([["before", place - 1], ["after", place + 1]])) {
      element(name).hidden = this.#figures[other] === undefined;
      byId(`class-${name}`, HTMLAnchorElement).href = `#class?figure=${this.#figures[other]?.name}`;
    }
    this.#showControls();
    this.#frame.draw();
    this.#dials[0].tell(refused);
  }

  /** Draws on canvases that the browser has emptied. */
  restore() {
    this.#frame.draw();
  }

  /** Called when the view is hidden. */
  hide() {
    this.#frame.cancel();
  }

  /** What is drawn, for tests. @returns {Told} */
  get state() {
    return JSON.parse(this.#class.told());
  }

  /** The figure that is shown. */
  get #figure() {
    const { figure } = this.state;
    return /** @type {Figure} */ (this.#figures.find(({ name }) => name === figure));
  }

  /** @type {(name: string, value: string) => void} */
  #set(name, value) {
    this.#class.set(name, value);
    this.#frame.request();
  }

  /** Shows the choice, and the dial that it chooses or else all dials. */
  #showControls() {
    const { parameters, which } = this.#figure;
    const { values } = this.state;
    const choice = parameters.find(({ options }) => options);
    element("choice").hidden = choice === undefined;
    if (choice?.options) {
      element("select-label").textContent = choice.label;
      select().name = choice.name;
      select().replaceChildren(...choice.options.map(([name, label]) => new Option(label, name, false, name === values[choice.name])));
    }
    const dials = parameters.filter(({ name, options }) => !options && (choice?.name !== which || name === values[which]));
    for (const [i, dial] of this.#dials.entries()) {
      dial.tell("");
      element(`dial-${i}`).hidden = dials[i] === undefined;
      if (dials[i] === undefined) continue;
      const { name, label, unit, ends: [least, most], isLogarithmic } = dials[i];
      this.#names[i] = name;
      element(`label-${i}`).textContent = label;
      element(`unit-${i}`).textContent = unit;
      element(`number-${i}`).setAttribute("aria-label", `${label}${unit && `, ${unit.trim()}`}`);
      dial.range(exact(least), exact(most), unit, isLogarithmic);
      dial.show(exact(Number(values[name])));
    }
  }

  #draw() {
    const { address, pictures, graph, numbers, refused } = this.state;
    element("pictures").replaceChildren(...pictures.map(({ label, seen, width, height }, i) => {
      const canvas = made("canvas", { width, height, role: "img", ariaLabel: seen });
      const pixels = /** @type {Uint8ClampedArray<ArrayBuffer>} */ (this.#class.pixels(i));
      canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
      const figure = made("figure", {}, canvas, made("figcaption", { className: "note", textContent: label }));
      // Pixels are not enlarged, and a strip has a row of its own.
      figure.style.maxWidth = `${width}px`;
      if (width > 3 * height) figure.style.flexBasis = "100%";
      return figure;
    }));
    element("graph").hidden = graph === null;
    if (graph) {
      const svg = byId("class-curve", SVGElement);
      svg.replaceChildren(...drawn(graph));
      svg.setAttribute("aria-label", `${graph.up[0]} over the ${graph.across[0]}: ${graph.curves.map(([name]) => name).join(", ")}`);
      element("legend").replaceChildren(...graph.curves.map(([name], i) => {
        const sample = shape("svg", { class: "sample", viewBox: "0 0 24 8" });
        sample.append(shape("path", { class: KINDS[i], d: "M0 4H24" }));
        return made("li", {}, sample, name);
      }));
    }
    element("numbers").replaceChildren(...numbers.map(([name, value]) => row(name, [value])));
    element("refused").textContent = refused;
    element("link").textContent = `${location.href.split("#")[0]}#class?${address}`;
    remember("class", () => address);
    this.drawn += 1;
  }
}
