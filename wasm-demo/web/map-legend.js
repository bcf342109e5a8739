// The legend of the map over the picture.
import { colours, tidy } from "./numbers.js";

/** Formats a number of lights. */
const counted = (lights) => `${lights} ${lights === 1 ? "light" : "lights"}`;

export class MapLegend {
  #stage;
  #select = document.getElementById("map-subject");
  #map = document.getElementById("map");
  #legends = { lights: document.getElementById("map-lights"), tiles: document.getElementById("map-tiles") };
  #ticks = ["start", "total", "end"].map((tick) => document.getElementById(`map-${tick}`));
  #bar = document.getElementById("map-bar");
  #screen;

  constructor(stage, screen) {
    this.#stage = stage;
    this.#screen = screen;
    this.#bar.style.background = `linear-gradient(90deg, ${colours(stage.palette()).join()})`;
    const [relit, kept] = colours(stage.tileColours());
    document.getElementById("map-relit").style.background = relit;
    document.getElementById("map-kept").style.background = kept;
  }

  /** Shows the subject. */
  show() {
    this.#select.value = this.#stage.map;
  }

  /** Draws the map of the last picture, if it has a subject. */
  draw() {
    const pixels = this.#stage.drawMap(this.#screen.counts, this.#screen.width);
    this.#map.hidden = pixels.length === 0;
    if (pixels.length > 0) this.#screen.showMap(pixels);
    const { map, mapEnd: end, mapTotal: total } = this.#stage;
    this.#legends.lights.hidden = map !== "lights" && map !== "cost";
    this.#legends.tiles.hidden = map !== "tiles";
    const isCost = map === "cost";
    const ticks = isCost ? ["0", `${tidy(total)} ms of a core in all`, `${tidy(end)} ns a pixel`] : ["no light", "", counted(end)];
    ticks.forEach((text, i) => (this.#ticks[i].textContent = text));
    this.#bar.setAttribute("aria-label", `From ${ticks[0]}, dark blue, to ${ticks[2]}, pale yellow`);
  }
}
