// The scenes: one at a time, with the effects that it needs, the skipped work, and the saving.
import { Scenes } from "./pkg/wasm_demo.js";
import { remember } from "./address.js";
import { AccountTable } from "./account-table.js";
import { EffectList } from "./effect-list.js";
import { accuracy } from "./format-picker.js";
import { LightList } from "./light-list.js";
import { MapLegend } from "./map-legend.js";
import { whole } from "./numbers.js";
import { plain } from "./plain.js";
import { Player } from "./player.js";
import { Readout } from "./readout.js";
import { SceneMeter } from "./scene-meter.js";
import { StageView } from "./stage-view.js";

const element = (name) => document.getElementById(`scene-${name}`);

export class ScenesView {
  #scenes = new Scenes(element("view"), element("map"));
  #view;
  #player;
  #readout = new Readout(this.#scenes, "scene-");
  #account = new AccountTable();
  #effects = new EffectList(this.#scenes);
  #lights = new LightList(this.#scenes);
  #legend = new MapLegend(this.#scenes);
  #examples = new Map(Scenes.examples().map((example) => [example.name, plain(example)]));
  #everything = element("everything");

  constructor() {
    const scenes = this.#scenes;
    const shown = {
      draw: () => this.#try(() => scenes.draw()) ?? false,
      orbit: (yaw, pitch) => scenes.orbit(yaw, pitch),
      zoom: (factor) => scenes.zoom(factor),
    };
    this.#view = new StageView(shown, element("view"));
    this.#player = new Player(scenes);
    this.#view.before((now) => this.#player.step(now));
    this.#view.after(() => this.#tell());
    this.#player.onchange = () => this.#move();
    this.#effects.onswitch = (effect, on) => {
      const taken = this.#ask(() => scenes.setEffect(effect, on));
      this.#request();
      return taken;
    };
    this.#lights.onchange = () => this.#request();
    this.#legend.onchange = () => {
      this.#legend.draw();
      this.#remember();
    };
    for (const { name, title } of this.#examples.values()) element("name").add(new Option(title, name));
    element("name").addEventListener("input", (event) => this.open(event.target.value));
    element("format").addEventListener("input", (event) => this.setFormat(event.target.value));
    this.#everything.addEventListener("input", () => {
      scenes.setEverything(this.#everything.checked);
      this.#request();
    });
    element("compare").addEventListener("click", () => this.#showEquality());
    this.#opened();
  }

  /** How many pictures have been drawn. */
  get drawn() {
    return this.#view.drawn;
  }

  /** The name of the scene. */
  get example() {
    return this.#scenes.example;
  }

  /** The costs of the last picture's light: a plain object. */
  get account() {
    return plain(this.#scenes.account());
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.#scenes.pixels();
  }

  /** Returns whether a pixel of the last picture is brighter than black. */
  get isLit() {
    return this.pixels().some((code, place) => place % 4 < 3 && code > 0);
  }

  /** Applies the address, such as `scene=grid&map=lights`. Refusals are shown. */
  show(query) {
    this.#view.pause(false);
    const [name, map] = [query.get("scene"), query.get("map")];
    if (map !== null) this.#ask(() => this.#legend.choose(map));
    if (name !== null && name !== this.example) this.open(name);
    this.#remember();
    this.#request();
  }

  /** Called when the view is hidden. */
  hide() {
    this.#view.pause(true);
  }

  /** Opens a scene in its original state. */
  open(name) {
    if (this.#ask(() => this.#scenes.open(name))) this.#opened();
    else element("name").value = this.example;
  }

  /** Requests a number format: `fx16`, `fx32` or `f32`. */
  setFormat(name) {
    this.#ask(() => this.#scenes.setFormat(name));
    this.#tellFormat();
    this.#request();
  }

  /**
   * Lights the picture with the needed effects, and again with all effects; compares both bit for
   * bit.
   */
  compare() {
    return plain(this.#scenes.compare());
  }

  /** See `SceneMeter.measure`. Afterwards the previous scene is opened again. */
  async measure(name, frames, options) {
    const { example, format } = this.#scenes;
    this.#player.stop();
    this.#view.pause(true);
    try {
      return await new SceneMeter(this.#scenes).measure(name, frames, options);
    } finally {
      this.#scenes.setEverything(this.#everything.checked);
      this.#scenes.setFormat("f32");
      this.#scenes.open(example);
      this.#scenes.setFormat(format);
      this.#view.pause(false);
      this.#opened();
    }
  }

  /**
   * Tries a change and returns whether it was accepted. The message of a refusal stays until the
   * next change.
   */
  #ask(act) {
    element("error").textContent = "";
    return this.#try(() => {
      act();
      return true;
    });
  }

  /** Does something that may be refused, and shows the message of the refusal; undefined then. */
  #try(act) {
    try {
      return act();
    } catch (refusal) {
      // The module refuses with a string; anything else is a bug in the page.
      if (typeof refusal !== "string") throw refusal;
      this.#player.stop();
      element("error").textContent = refusal;
      return undefined;
    }
  }

  #tellFormat() {
    const { format } = this.#scenes;
    element("format").value = format;
    element("format-note").textContent = accuracy(format);
  }

  /** Shows the current scene. */
  #opened() {
    const { title, summary } = this.#examples.get(this.example);
    const { width, height } = this.#scenes;
    element("name").value = this.example;
    this.#tellFormat();
    element("summary").textContent = summary;
    element("size").textContent = `The picture has ${width} × ${height} pixels.`;
    element("view").setAttribute("aria-label", `The scene: ${title}`);
    this.#player.open();
    this.#effects.open();
    this.#lights.open();
    this.#remember();
    this.#request();
  }

  /** Updates the address, so that it can be shared. */
  #remember() {
    const { subject: map } = this.#legend;
    const query = new URLSearchParams({ scene: this.example, ...(map !== "nothing" && { map }) });
    remember("scenes", query);
  }

  /** Called when something other than the time has changed: earlier figures no longer apply. */
  #request() {
    this.#readout.forget();
    this.#move();
  }

  /** Called when an animation starts or stops: the time per picture is unchanged. */
  #move() {
    this.#account.forget();
    element("equality").textContent = "";
    this.#view.request();
  }

  #tell() {
    if (!this.#player.isPlaying) this.#account.forget();
    this.#readout.add();
    this.#account.add(this.account, this.#scenes.width * this.#scenes.height);
    this.#effects.show();
    this.#legend.draw();
  }

  #showEquality() {
    element("error").textContent = "";
    const found = this.#try(() => this.compare());
    if (!found) return;
    const { pixels, differing, evaluated, pairs, lightingMs, everythingMs } = found;
    const same = differing === 0 ? `All ${whole(pixels)} pixels are equal, bit for bit` : `${whole(differing)} pixels differ`;
    element("equality").textContent =
      `${same}: ${whole(evaluated)} pairs of light and pixel in ${lightingMs.toFixed(1)} ms, ` +
      `and all ${whole(pairs)} in ${everythingMs.toFixed(1)} ms.`;
  }
}
