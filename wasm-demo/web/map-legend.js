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

  /** The subject of the map that was drawn last. */
  #drawn = "nothing";

  constructor(stage) {
    this.#stage = stage;
    this.#bar.style.background = `linear-gradient(90deg, ${colours(stage.palette()).join()})`;
    const [relit, kept] = colours(stage.tileColours());
    document.getElementById("map-relit").style.background = relit;
    document.getElementById("map-kept").style.background = kept;
  }

  /** Shows the subject. */
  show() {
    this.#select.value = this.#stage.map;
  }

  /** Whether the map shows another subject than chosen. */
  get isStale() {
    return this.#drawn !== this.#stage.map;
  }

  /** Draws the map of the last picture, if it has a subject. */
  draw() {
    this.#drawn = this.#stage.map;
    this.#map.hidden = !this.#stage.drawMap();
    for (const [subject, legend] of Object.entries(this.#legends)) legend.hidden = subject !== this.#stage.map;
    const end = this.#stage.mapEnd;
    this.#end.textContent = counted(end);
    this.#bar.setAttribute("aria-label", `From no light, dark blue, to ${counted(end)}, pale yellow`);
  }
}
