// The legend of the map over the picture.
import { colours } from "./numbers.js";

/** Formats a number of lights. */
const counted = (lights) => `${lights} ${lights === 1 ? "light" : "lights"}`;

export class MapLegend {
  #scenes;
  #select = document.getElementById("scene-map-subject");
  #map = document.getElementById("scene-map");
  #legends = { lights: document.getElementById("map-lights"), tiles: document.getElementById("map-tiles") };
  #end = document.getElementById("map-end");
  #bar = document.getElementById("map-bar");

  /** Called when the subject of the map changes. */
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

  /** The subject of the map: `nothing`, `lights` or `tiles`. */
  get subject() {
    return this.#select.value;
  }

  /**
   * Sets the subject, from the next draw on; throws the module's message for an unknown subject.
   */
  choose(subject) {
    this.#scenes.setMap(subject);
    this.#select.value = subject;
  }

  /** Draws the map of the last picture, if it has a subject. */
  draw() {
    this.#map.hidden = !this.#scenes.drawMap();
    for (const [subject, legend] of Object.entries(this.#legends)) legend.hidden = subject !== this.#select.value;
    const end = this.#scenes.mapEnd;
    this.#end.textContent = counted(end);
    this.#bar.setAttribute("aria-label", `From no light, dark blue, to ${counted(end)}, pale yellow`);
  }
}
