// The legend of the map over the picture.
import { element } from "./elements.js";
import { colours, counted, tidy } from "./numbers.js";

/** @typedef {import("./pkg/wasm_demo.js").Stage} Stage */
/** @typedef {import("./screen.js").Screen} Screen */

export class MapLegend {
  #stage;
  #map = element("map", HTMLCanvasElement);
  #legends = { lights: element("map-lights"), tiles: element("map-tiles") };
  #ticks = ["start", "total", "end"].map((tick) => element(`map-${tick}`));
  #bar = element("map-bar");
  #screen;

  /**
   * @param {Stage} stage
   * @param {Screen} screen
   */
  constructor(stage, screen) {
    this.#stage = stage;
    this.#screen = screen;
    this.#bar.style.background = `linear-gradient(90deg, ${colours(stage.palette()).join()})`;
    const [relit, kept] = colours(stage.tileColours());
    element("map-relit").style.background = relit;
    element("map-kept").style.background = kept;
  }

  /** Draws the map of the last picture, if it has a subject. */
  draw() {
    const pixels = this.#stage.drawMap(this.#screen.counts, this.#screen.width);
    this.#map.hidden = pixels.length === 0;
    if (pixels.length > 0) this.#screen.showMap(pixels);
    const { mapEnd: end, mapTotal: total } = this.#stage;
    const map = this.#stage.get("map");
    this.#legends.lights.hidden = map !== "lights" && map !== "cost";
    this.#legends.tiles.hidden = map !== "tiles";
    const isCost = map === "cost";
    const ticks = isCost ? ["0", `${tidy(total)} ms of a core in all`, `${tidy(end)} ns a pixel`] : ["no light", "", counted(end, "light")];
    ticks.forEach((text, i) => (this.#ticks[i].textContent = text));
    this.#bar.setAttribute("aria-label", `From ${ticks[0]}, dark blue, to ${ticks[2]}, pale yellow`);
  }
}
