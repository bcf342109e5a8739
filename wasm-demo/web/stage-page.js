// The stage: one scene under the visitor's settings. The module holds the state; the page shows it.
import { AccountTable } from "./account-table.js";
import { remember } from "./address.js";
import { CameraView } from "./camera-view.js";
import { CodeSlot } from "./code-slot.js";
import { Controls } from "./controls.js";
import { DividedPicture } from "./divided.js";
import { EffectList } from "./effect-list.js";
import { element } from "./elements.js";
import { aside, refusalOf, words } from "./failure.js";
import { takeFiles } from "./file-slot.js";
import { LightList } from "./light-list.js";
import { LightPanel } from "./light-panel.js";
import { MapLegend } from "./map-legend.js";
import { tidy, whole } from "./numbers.js";
import { isBuilt } from "./parts.js";
import { plain } from "./plain.js";
import { MISSING } from "./pool.js";
import { PriceSlot } from "./price-slot.js";
import { Readout } from "./readout.js";
import { ScenePicker } from "./scene-picker.js";
import { now } from "./share.js";
import { load } from "./support.js";
import { joinTabs } from "./tabs.js";

/** @typedef {import("./camera-view.js").Picture} Shown */
/** @typedef {Awaited<ReturnType<import("./pool.js").Pool["draw"]>>} Drawn */
/** @typedef {Drawn["times"] & { show?: number }} Times of the passes, in milliseconds */

/** @param {string} id */
const input = (id) => element(id, HTMLInputElement);
/** @param {string} id */
const button = (id) => element(id, HTMLButtonElement);

/** Longest time between two pictures that an animation follows, in seconds. */
const LONGEST_STEP = 0.25;

/**
 * Time without a change after which a picture that does not move is drawn in the resolution of the
 * device, in milliseconds.
 */
const REST = 150;

/** What stands beside the button that verifies it. */
const EQUAL = "Only exact zeros are skipped: the picture is the same, bit for bit.";

const isMotionWanted = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;

export class StagePage {
  #stage;
  #pool;
  #screen;
  #module;
  #divided;
  #view;
  #controls;
  #scenes = new ScenePicker();
  #readout = new Readout();
  #account = new AccountTable();
  #effects;
  #lights;
  #panel;
  #price = new PriceSlot();
  #code = new CodeSlot();
  #legend;
  /**
   * The curve, once it is loaded.
   * @type {import("./curve.js").Curve | undefined}
   */
  #curve;
  /**
   * The lights over the picture, once they are loaded.
   * @type {import("./handles.js").Handles | undefined}
   */
  #handles;
  /**
   * What the format changes in the picture, once it is loaded.
   * @type {import("./verdict.js").Verdict | undefined}
   */
  #verdict;
  /**
   * Moves the edge of a divided picture, once it is loaded.
   * @type {{ sweep: import("./sweep.js").Sweep, paths: typeof import("./sweep.js") } | undefined}
   */
  #edge;
  /** Whether a new visitor sees the first picture, and has not touched it. */
  #isNew = false;
  /** Whether the edge between integers and floats moves over that picture. */
  #isSwept = false;
  #isOpen = false;
  /** Whether a pointer is down: what it drags is one step to undo, however long it takes. */
  #isHeld = false;
  /**
   * The time of the last picture of an animation.
   * @type {number | undefined}
   */
  #last;
  /**
   * The job that the pool has drawn last.
   * @type {string | undefined}
   */
  #drawnJob;
  /** How many jobs the pool was asked to draw. */
  #number = 0;
  /** Whether the canvas shows its picture. */
  #isShown = true;
  /** What lighting the last picture took, in milliseconds of a core. */
  #lighting = 0;
  /**
   * The account and the times of the last picture in the size of pictures that move.
   * @type {{ account?: Drawn["account"], times?: Times }}
   */
  #told = {};
  /** Whether pictures have the resolution of the device at rest. */
  #rests;
  /** @type {number | undefined} */
  #timer;

  /**
   * @param {import("./pkg/wasm_demo.js").Stage} stage
   * @param {import("./pool.js").Pool} pool
   * @param {import("./screen.js").Screen} screen
   * @param {WebAssembly.Module} module
   * @param {{ rests?: boolean }} [options]
   */
  constructor(stage, pool, screen, module, { rests = true } = {}) {
    this.#stage = stage;
    this.#pool = pool;
    this.#screen = screen;
    this.#module = module;
    this.#rests = rests;
    this.#divided = new DividedPicture(module, pool.size);
    this.#view = new CameraView(element("view", HTMLCanvasElement), {
      orbit: (yaw, pitch) => this.#move(() => stage.orbit(yaw, pitch)),
      zoom: (factor) => this.#move(() => stage.zoom(factor)),
      reset: () => this.#move(() => stage.resetCamera()),
      draw: (now, onfree) => this.#draw(now, onfree),
    });
    this.#controls = new Controls(stage, (act) => this.#set(act));
    this.#effects = new EffectList(stage);
    this.#lights = new LightList(stage);
    this.#panel = new LightPanel(stage);
    this.#legend = new MapLegend(stage, screen);
    takeFiles({
      throwOf: () => (stage.lightCount > 0 ? plain(stage.light(this.#lights.selected)).throw : undefined) ?? 4,
      put: ({ settings, intensity, isCandela }) => {
        const { selected } = this.#lights;
        const refusal = refusalOf(() => stage.putLight(selected, settings ?? "", intensity, isCandela));
        const isDark = refusal || refusalOf(() => stage.exposeFor(selected));
        this.#changed();
        const exposed = isDark ? "It lights no surface." : `The picture is exposed for it, by ${tidy(stage.get("exposure"))} EV.`;
        return refusal || `It is light ${element("panel-title").textContent}, here and in the link. ${exposed}`;
      },
      putLeds: ({ places, facing, told }) => {
        const refusal = refusalOf(() => stage.putLeds(places, facing));
        this.#changed();
        return refusal || `${told} They are on the tree's stage, but not in the link.`;
      },
    });
    joinTabs();
    this.#join();
    this.#joinSteps();
  }

  /** How many pictures have been drawn. */
  get drawn() {
    return this.#view.drawn;
  }

  /** The price of the selected light; undefined until it is in view. */
  get price() {
    return this.#price.panel;
  }

  /**
   * The selected light, its name, and a job of the stage that has it.
   * @returns {import("./use-view.js").Selected | undefined}
   */
  get selected() {
    const light = this.#lights.selected;
    if (light >= this.#stage.lightCount) return undefined;
    return { job: this.#stage.job(), light, name: `${light + 1} ${plain(this.#stage.light(light)).name}` };
  }

  /** Whether a picture is being drawn or will be. */
  get isDrawing() {
    return this.#view.isDrawing;
  }

  /** The memory of the workers' modules in bytes. */
  memory() {
    return this.#pool.memory();
  }

  /** A copy of the last picture: RGBA, sRGB, eight bits. */
  pixels() {
    return this.#screen.pixels.slice();
  }

  /** The difference between both halves of the picture; undefined if it is whole. */
  get difference() {
    return this.#divided.difference;
  }

  /** What was evaluated for the last picture. */
  get account() {
    return this.#told.account;
  }

  /** The times of the last picture in milliseconds: see `Pool.draw`. */
  get times() {
    return this.#told.times;
  }

  /**
   * Takes the state of the address; without one it stays as it is. Refusals are shown. Resolves when
   * there is a picture.
   * @param {string} query
   */
  async show(query) {
    this.#view.pause(false);
    if (this.#isOpen && query === "") return this.#changed();
    const isFirst = !this.#isOpen;
    this.#isOpen = true;
    const refused = this.#stage.recall(query);
    // Nothing moves by itself for a visitor who wants no motion.
    if (!isMotionWanted() && !new URLSearchParams(query).has("play")) this.#stage.play(false, false);
    if (isFirst) this.#stage.begin();
    this.#changed();
    this.#isNew = isFirst && query === "" && isMotionWanted();
    element("stage-error").textContent = refused;
    if (!isFirst) return;
    await this.#view.draw(now());
    this.#loadLater();
    this.#drawScenes();
  }

  /** Shows all pictures again on canvases that the browser has emptied. */
  restore() {
    if (this.drawn === 0) return;
    this.#isShown = false;
    const isShown = this.#show();
    this.#legend.draw();
    this.#divided.show(this.#screen.pixels, isShown, this.#screen.width);
    this.#drawScenes();
  }

  /** Called when the view is hidden. */
  hide() {
    clearTimeout(this.#timer);
    this.#touch();
    this.#verdict?.stop();
    this.#view.pause(true);
  }

  /**
   * Requests a number format: `fx16`, `fx32` or `f32`.
   * @param {string} name
   */
  setFormat(name) {
    this.#set(() => this.#stage.set("format", name));
  }

  /** Draws the current picture, if it is not on the canvas. */
  redraw() {
    return this.#view.draw(now());
  }

  /** Lights the picture with the needed effects and with all, and compares the two bit for bit. */
  compare() {
    return this.#pool.compare(this.#jobs()[0]);
  }

  #drawScenes() {
    this.#scenes.draw(this.#module).catch((error) => reportError(new Error(words(error))));
  }

  #join() {
    const stage = this.#stage;
    this.#scenes.onchange = (scene) => this.#set(() => stage.open(scene));
    for (const id of ["play", "camera"]) element(id).addEventListener("input", () => this.#play());
    /** @type {(id: string, act: () => void) => void} */
    const onclick = (id, act) => element(id).addEventListener("click", act);
    onclick("undo", () => this.#set(() => stage.undo()));
    onclick("redo", () => this.#set(() => stage.redo()));
    onclick("reset", () => this.#set(() => stage.open(stage.scene)));
    onclick("copy", () => this.#copyLink());
    onclick("save", () => this.#save());
    onclick("full", () => this.#fillScreen());
    onclick("verify", () => this.#verify());
    this.#price.onformat = (format) => this.setFormat(format);
    this.#effects.onswitch = (effect, isOn) => this.#set(() => stage.setEffect(effect, isOn));
    this.#lights.onchange = (act) => this.#set(act);
    this.#lights.onselect = () => this.#showLight();
    this.#panel.onchange = (source) => {
      element("stage-error").textContent = "";
      this.#changed(source);
    };
    this.#panel.onlist = (act) => this.#set(act);
    document.addEventListener("keydown", (event) => this.#key(event));
    // Also when the window moves to a display of another resolution.
    addEventListener("resize", () => this.#move(() => {}));
  }

  /** Loads what the first picture goes before. A failure is reported, and the rest works. */
  #loadLater() {
    /** @type {<T>(file: string, join: (module: T) => void) => Promise<void>} */
    const later = async (file, join) => join(await load(file));
    /** @type {(module: typeof import("./curve.js")) => void} */
    const joinCurve = ({ Curve }) => {
      const curve = new Curve(this.#stage);
      curve.onset = (name, value, handle) => {
        if (name === undefined || value === undefined || handle === undefined) this.#showLight();
        else this.#panel.setNumber(name, value, handle);
      };
      this.#curve = curve;
      this.#showLight();
    };
    /** @type {(module: typeof import("./handles.js")) => void} */
    const joinHandles = ({ Handles }) => {
      const handles = new Handles(this.#stage, this.#lights);
      handles.onselect = (light) => {
        this.#lights.selected = light;
        this.#lights.show();
        this.#showLight();
      };
      handles.onchange = (act) => this.#set(act);
      this.#handles = handles;
      handles.show();
      handles.follow(this.#last !== undefined);
    };
    /** @type {(module: typeof import("./verdict.js")) => void} */
    const joinVerdict = ({ Verdict }) => {
      this.#verdict = new Verdict(this.#stage, this.#module, (job) => (job === this.#drawnJob && this.#isShown ? this.pixels() : undefined));
      this.#verdict.onwhere = (format) => this.#set(() => {
        this.#stage.set("with", format);
        this.#stage.set("difference", true);
      });
      this.#verdict.onbeside = (format) => {
        this.#set(() => {
          this.#stage.set("with", format);
          this.#stage.set("difference", false);
        });
        this.#open();
      };
      this.#verdict.onbuilt = () => this.#changed();
      this.#verdict.onmeasured = () => this.#introduce().catch((error) => reportError(new Error(words(error))));
      this.#verdict.show();
      this.#verdict.later();
    };
    /** @type {(paths: typeof import("./sweep.js")) => void} */
    const joinSweep = (paths) => (this.#edge = { sweep: new paths.Sweep((percent) => this.#divided.divider.move(percent)), paths });
    const seen = [later("curve.js", joinCurve), later("handles.js", joinHandles)].map((loading) => loading.catch(reportError));
    // It needs a second module, which comes after what is seen at once.
    Promise.all(seen)
      .then(() => later("sweep.js", joinSweep))
      .then(() => later("verdict.js", joinVerdict))
      .catch(reportError);
  }

  /** Moves the edge between integers and floats once over the first picture, which stays as it is. */
  async #introduce() {
    const stage = this.#stage;
    if (!this.#isNew || stage.get("format") !== "fx16" || stage.get("with")) return;
    const { width, height } = stage;
    // Its workers start while the pictures go on.
    await this.#divided.draw(stage.jobIn("f32"), { width, height });
    if (!this.#isNew) return this.#view.request();
    this.#isSwept = true;
    this.#edge?.sweep.start(this.#edge.paths.OVER, () => this.#touch());
    this.#divided.divide("fx16", "f32");
    this.#view.request();
  }

  /**
   * The first picture is no longer untouched: the edge that moves over it is gone.
   * @param {EventTarget | null} [target] what the visitor has pressed: the edge itself stays
   */
  #touch(target) {
    this.#isNew = false;
    this.#edge?.sweep.stop();
    if (!this.#isSwept) return;
    this.#isSwept = false;
    this.#divided.divide("fx16", undefined);
    if (target instanceof Element && target.matches(".divider")) this.#set(() => this.#stage.set("with", "f32"));
    else this.#view.request();
  }

  /** Opens a picture that has been divided, from its side. */
  #open() {
    if (this.#stage.get("with") && isMotionWanted()) this.#edge?.sweep.start(this.#edge.paths.OPEN);
    else this.#divided.divider.move(50);
  }

  /**
   * Makes one step to undo of what the visitor drags, from where the first pointer goes down. Where the
   * browser takes the pointer for itself, as for a swipe that scrolls, there was no step.
   */
  #joinSteps() {
    const page = element("stage-page");
    for (const touch of ["pointerdown", "keydown", "wheel"]) {
      page.addEventListener(touch, ({ target }) => this.#touch(target), { capture: true, passive: true });
    }
    page.addEventListener("pointerdown", ({ isPrimary }) => {
      if (!isPrimary) return;
      this.#stage.mark();
      this.#isHeld = true;
      this.#grip();
    }, true);
    // Of a small window the picture takes the rest.
    page.addEventListener("focusin", ({ target }) => {
      if (target instanceof HTMLInputElement && matchMedia("(max-height: 299px)").matches) target.scrollIntoView({ block: "end" });
    });
    // A field is changed before it loses the focus, and that is where the next gesture begins.
    for (const turn of ["focusin", "focusout"]) page.addEventListener(turn, () => this.#grip());
    window.addEventListener("pointercancel", ({ isPrimary }) => {
      if (isPrimary && this.#isHeld && this.#stage.cancel()) this.#changed();
    });
    for (const end of ["pointerup", "pointercancel", "blur"]) {
      window.addEventListener(end, () => {
        if (this.#isHeld) {
          this.#isHeld = false;
          this.#grip();
          this.#remember();
        }
      });
    }
  }

  /** Begins a gesture, and shows where its dials end. A number that is being typed stays. */
  #grip() {
    this.#stage.grip();
    // While the list of lights is renewed, the selected one may be gone.
    if (this.#lights.selected >= this.#stage.lightCount) return;
    const field = document.activeElement;
    this.#panel.show(this.#lights.selected, field?.matches("input:not([type=range])") ? field : undefined);
  }

  /**
   * Changes the state. A refusal is shown and changes nothing else.
   * @param {() => void} act
   */
  #set(act) {
    element("stage-error").textContent = refusalOf(act);
    this.#changed();
  }

  /** Lets lights and camera move or stand still; earlier times stay valid. */
  #play() {
    this.#last = undefined;
    this.#account.forget();
    this.#move(() => this.#stage.play(input("play").checked, input("camera").checked));
  }

  /**
   * Moves the camera; earlier times stay valid. Returns what `act` returns.
   * @template T
   * @param {() => T} act
   * @returns {T}
   */
  #move(act) {
    const moved = act();
    this.#stir();
    this.#remember();
    this.#view.request();
    return moved;
  }

  /**
   * Shows the state, except on the control that a change comes from, and draws it.
   * @param {Element} [source]
   */
  #changed(source) {
    const stage = this.#stage;
    this.#scenes.show(stage.scene);
    element("summary").textContent = this.#scenes.summary;
    element("view").setAttribute("aria-label", `The scene: ${this.#scenes.title}`);
    element("frame").classList.toggle("pixels", stage.showsPixels);
    element("frame").style.setProperty("--rows", `${stage.height}px`);
    input("play").checked = stage.lightsPlay;
    input("play").disabled = !stage.lightsMove;
    input("camera").checked = stage.cameraPlays;
    input("camera").disabled = !stage.cameraMoves;
    this.#controls.show();
    if (this.#isSwept) this.#touch();
    this.#divided.cover(stage.get("format"), this.#jobs()[1] && String(stage.get("with")), stage.get("difference"));
    this.#verdict?.show();
    element("equality").textContent = EQUAL;
    element("told").textContent = "";
    this.#lights.show();
    this.#effects.open();
    this.#showLight(source);
    this.#readout.forget();
    this.#account.forget();
    this.#last = undefined;
    this.#stir();
    this.#remember();
    this.#view.request();
  }

  /** Draws pictures in the size of those that move, until nothing has changed for a while. */
  #stir() {
    clearTimeout(this.#timer);
    this.#stage.rest();
    if (this.#rests) this.#timer = setTimeout(() => this.#rest(), REST);
  }

  /** Draws the picture in the resolution of the device, if nothing moves. */
  #rest() {
    const stage = this.#stage;
    if (stage.lightsPlay || stage.cameraPlays) return;
    if (this.#view.isDrawing) {
      this.#timer = setTimeout(() => this.#rest(), REST);
      return;
    }
    const width = Math.round(element("view").getBoundingClientRect().width * devicePixelRatio);
    if (width === 0 || !stage.rest(width)) return;
    this.#view.request();
    this.#verdict?.later();
  }

  /** @param {Element} [source] the control that a change comes from */
  #showLight(source) {
    this.#panel.show(this.#lights.selected, source);
    aside(() => this.#curve?.draw(this.#lights.selected));
    aside(() => this.#handles?.show());
    const { lightCount, fullScale } = this.#stage;
    const { selected } = this.#lights;
    const light = selected < lightCount ? plain(this.#stage.light(selected)) : undefined;
    /** @type {number[] | undefined} */
    let found;
    const distances = () => (found ??= Array.from(this.#stage.distances(selected)));
    const job = () => this.#stage.job();
    const priced = light && { ...light, intensity: light.strongest / fullScale, job, number: selected, distances };
    this.#price.show(priced, this.#stage.get("format"));
    if (!light) return;
    aside(() => this.#code.show({ job: this.#stage.job(), light: selected }));
    // The comparison opens with the beam that the visitor comes from.
    if (light.isSpot) element("compare-link", HTMLAnchorElement).href = `#compare?half=${tidy(light.outer / 2)}`;
  }

  /** Updates the address and the states to return to, once the visitor pauses. */
  #remember() {
    const stage = this.#stage;
    this.#verdict?.later();
    this.#showReturns();
    remember("stage", () => {
      if (!this.#isHeld) stage.mark();
      this.#showReturns();
      return stage.address();
    });
  }

  #showReturns() {
    button("undo").disabled = !this.#stage.canUndo;
    button("redo").disabled = !this.#stage.canRedo;
  }

  /**
   * The jobs of the picture and of its other half. Until what draws in 32 bits is built, the picture is
   * whole and in 16 bits, and the sentence below it says so.
   * @returns {[string, string?]}
   */
  #jobs() {
    const stage = this.#stage;
    if (isBuilt("wide")) return [stage.job(), this.#isSwept ? stage.jobIn("f32") : stage.otherJob()];
    return [stage.get("format") === "fx16" ? stage.job() : stage.jobIn("fx16")];
  }

  /**
   * Draws what has changed: see `CameraView`.
   * @param {number} now
   * @param {() => void} onfree
   * @returns {Promise<Shown>}
   */
  async #draw(now, onfree) {
    const stage = this.#stage;
    const step = Math.min((now - (this.#last ?? now)) / 1000, LONGEST_STEP);
    const isPlaying = stage.advance(step);
    this.#last = isPlaying ? now : undefined;
    const [job, other] = this.#jobs();
    const { isAtRest } = stage;
    if (job === this.#drawnJob && this.#divided.hasDrawn(other)) return { goesOn: isPlaying, show: () => this.#show() };
    const { width, height } = stage;
    this.#drawnJob = undefined;
    const number = (this.#number += 1);
    try {
      // The other half of a divided picture comes before the next picture.
      const picture = await this.#pool.draw(job, other === undefined ? onfree : undefined);
      await this.#divided.draw(other, { width, height });
      if (number === this.#number) this.#drawnJob = job;
      return { goesOn: isPlaying, show: () => this.#take({ ...picture, width, height, isPlaying, isAtRest }) };
    } catch (refusal) {
      // A picture of so many pixels may not fit into memory.
      if (isAtRest && typeof refusal === "string") {
        this.#rests = false;
        stage.rest();
      } else this.#refuse(refusal);
      return { goesOn: false, show: () => false };
    }
  }

  /**
   * Takes a picture of the pool and shows it. Returns whether it is another one: at rest it is the
   * same in another resolution, and the readout keeps the figures of before.
   * @param {Drawn & { times: Times, width: number, height: number, isPlaying: boolean, isAtRest: boolean }} picture
   */
  #take({ isDrawn, parts, account, times, width, height, isPlaying, isAtRest }) {
    const start = now();
    this.#screen.count(parts, height);
    if (isDrawn) {
      this.#screen.gather(parts, { width, height });
      this.#pool.recycle(parts);
      this.#isShown = false;
    }
    times.transfer += now() - start;
    const isShown = this.#show(times);
    if (isShown) {
      this.#lighting = parts.reduce((sum, part) => sum + (part.times.lighting ?? 0), 0);
      element("size").textContent = `The picture has ${width} × ${height} pixels.`;
    }
    if (isShown && !isAtRest) {
      this.#told = { account, times };
      aside(() => this.#tell(isPlaying, width * height));
    }
    aside(() => this.#legend.draw());
    const isDivided = this.#divided.show(this.#screen.pixels, isShown, width);
    return (isShown || isDivided) && !isAtRest;
  }

  /**
   * Shows the last picture, if the canvas has not taken it yet. Returns whether it has now.
   * @param {{ show?: number }} [times]
   */
  #show(times = {}) {
    if (this.#isShown) return false;
    const start = now();
    try {
      this.#screen.show();
    } catch (error) {
      this.#refuse(`The canvas has refused the picture: ${words(error)}`);
      return false;
    }
    this.#isShown = true;
    times.show = now() - start;
    return true;
  }

  /** @param {unknown} refusal */
  #refuse(refusal) {
    if (typeof refusal !== "string") throw refusal;
    clearTimeout(this.#timer);
    this.#stage.play(false, false);
    // The format of the state is that of the picture. A beam may be too narrow for 16 bits.
    const isLost = refusal.startsWith(MISSING) ? refusalOf(() => this.#takeShort()) : "";
    element("stage-error").textContent = isLost ? `${refusal} ${isLost}` : refusal;
  }

  /** Draws in 16 bits, as the page can do from the start. */
  #takeShort() {
    this.#stage.set("with", undefined);
    this.#stage.set("format", "fx16");
    this.#changed();
  }

  /**
   * @param {boolean} isPlaying
   * @param {number} pixels
   */
  #tell(isPlaying, pixels) {
    const { account, times } = this.#told;
    if (!account || !times) return;
    if (!isPlaying) this.#account.forget();
    this.#readout.add(times);
    this.#account.add(account, pixels);
    const { leds, ledCurrent, ledLimit } = account;
    element("leds").hidden = leds === 0;
    element("leds").textContent = `${leds} LEDs take ${(ledCurrent / 1000).toFixed(2)} A. The limit is ${ledLimit / 1000} A.`;
    this.#price.add(this.#lighting, account);
    this.#handles?.follow(isPlaying);
  }

  async #copyLink() {
    const link = `${location.href.split("#")[0]}#stage?${this.#stage.address()}`;
    try {
      await navigator.clipboard.writeText(link);
      element("told").textContent = "The link is copied.";
    } catch {
      element("told").textContent = `The browser copies nothing here. The link is ${link}`;
    }
  }

  #save() {
    const link = document.createElement("a");
    link.download = `luminaire-${this.#stage.scene}-${this.#stage.get("format")}.png`;
    element("view", HTMLCanvasElement).toBlob((blob) => {
      if (!blob) return;
      link.href = URL.createObjectURL(blob);
      link.click();
      URL.revokeObjectURL(link.href);
    });
  }

  async #fillScreen() {
    try {
      if (document.fullscreenElement) await document.exitFullscreen();
      else {
        await element("frame").requestFullscreen();
        element("view").focus();
      }
    } catch {
      element("told").textContent = "The browser does not let this page fill the screen.";
    }
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const isTyping = event.target instanceof Element && event.target.matches("input:not([type=checkbox], [type=radio]), select");
    if (isTyping || element("stage-page").hidden || event.altKey) return;
    const isCommand = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (isCommand && key === "z") this.#set(() => (event.shiftKey ? this.#stage.redo() : this.#stage.undo()));
    else if (isCommand && key === "y") this.#set(() => this.#stage.redo());
    else if (!isCommand && key === "f") this.#fillScreen();
    else if (!isCommand && key === "r") this.#move(() => this.#stage.resetCamera());
    else return;
    event.preventDefault();
  }

  async #verify() {
    const { pixels, differing, evaluated, pairs, lightingMs, everythingMs } = await this.compare();
    const same = differing === 0 ? `All ${whole(pixels)} pixels are equal, bit for bit` : `${whole(differing)} pixels differ`;
    element("equality").textContent =
      `${same}: ${whole(evaluated)} evaluations of a light at a pixel in ${lightingMs.toFixed(1)} ms, ` +
      `and all ${whole(pairs)} in ${everythingMs.toFixed(1)} ms.`;
  }
}
