// The legend of the map over the picture.
import { colours } from "./numbers.js";

/** Formats a number of lights. */
const counted = (lights) => `${lights} ${lights === 1 ? "light" : "lights"}`;

export class MapLegend {
  #stage;
  #select = document.getElementById("map-subject");
  #map = document.getElementById("map");
  #legends = { lights: document.getElementById("map-lights"), tiles: document.getElementById("map-tiles") };
  #end = document.getElementById("map-end");
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
    for (const [subject, legend] of Object.entries(this.#legends)) legend.hidden = subject !== this.#stage.map;
    const end = this.#stage.mapEnd;
    this.#end.textContent = counted(end);
    this.#bar.setAttribute("aria-label", `From no light, dark blue, to ${counted(end)}, pale yellow`);
  }
}
