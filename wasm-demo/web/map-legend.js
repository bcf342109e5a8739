// The map over the picture: what it shows, and its legend.
import { colours } from "./numbers.js";

/** A count of lights, in words. */
const counted = (lights) => `${lights} ${lights === 1 ? "light" : "lights"}`;

export class MapLegend {
  #scenes;
  #select = document.getElementById("scene-map-subject");
  #map = document.getElementById("scene-map");
  #legends = { lights: document.getElementById("map-lights"), tiles: document.getElementById("map-tiles") };
  #end = document.getElementById("map-end");
  #bar = document.getElementById("map-bar");

  /** Called when the map is of something else. */
  onchange = () => {};

  constructor(scenes) {
    this.#scenes = scenes;
    this.#bar.style.background = `linear-gradient(90deg, ${colours(scenes.palette()).join()})`;
    const [relit, kept] = colours(scenes.tileColours());
    document.getElementById("map-relit").style.background = relit;
    document.getElementById("map-kept").style.background = kept;
    this.#select.addEventListener("input", () => {
      this.choose(this.#select.value);
      this.onchange();
    });
  }

  /** What the map shows: `nothing`, `lights` or `tiles`. */
  get subject() {
    return this.#select.value;
  }

  /** Makes it show something else, with the next draw; throws the module's words where there is no such map. */
  choose(subject) {
    this.#scenes.setMap(subject);
    this.#select.value = subject;
  }

  /** Draws the map of the last picture, if there is to be one. */
  draw() {
    this.#map.hidden = !this.#scenes.drawMap();
    for (const [subject, legend] of Object.entries(this.#legends)) legend.hidden = subject !== this.#select.value;
    const end = this.#scenes.mapEnd;
    this.#end.textContent = counted(end);
    this.#bar.setAttribute("aria-label", `From no light, dark blue, to ${counted(end)}, pale yellow`);
  }
}
