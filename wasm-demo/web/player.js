// The switches that animate the lights and the camera of a scene.

/** A switch and the elapsed time of its animation. */
class Track {
  #switch;
  #last;

  /** Elapsed time of the animation. */
  seconds = 0;

  constructor(id, onchange) {
    this.#switch = document.getElementById(id);
    this.#switch.addEventListener("input", () => {
      this.#last = undefined;
      onchange();
    });
  }

  get isPlaying() {
    return this.#switch.checked;
  }

  /** Resets to rest; without anything to animate the switch is disabled. */
  open(moves) {
    this.seconds = 0;
    this.#last = undefined;
    this.#switch.disabled = !moves;
    if (!moves) this.stop();
  }

  stop() {
    this.#switch.checked = false;
  }

  step(now) {
    if (!this.isPlaying) return;
    this.seconds += (now - (this.#last ?? now)) / 1000;
    this.#last = now;
  }
}

export class Player {
  #scenes;
  #tracks;
  #note = document.getElementById("scene-still");

  /** Called when an animation starts or stops. */
  onchange = () => {};

  constructor(scenes) {
    this.#scenes = scenes;
    const track = (id) => new Track(id, () => this.onchange());
    this.#tracks = { lights: track("scene-play"), camera: track("scene-camera") };
  }

  /** Whether anything is animated. */
  get isPlaying() {
    return this.#tracks.lights.isPlaying || this.#tracks.camera.isPlaying;
  }

  /** Prepares for the current scene. A running animation continues from the beginning. */
  open() {
    const moves = { lights: this.#scenes.moves(), camera: this.#scenes.cameraMoves() };
    for (const [name, track] of Object.entries(this.#tracks)) track.open(moves[name]);
    this.#note.hidden = moves.lights || moves.camera;
  }

  /** Stops all animations where they are. */
  stop() {
    for (const track of Object.values(this.#tracks)) track.stop();
  }

  /**
   * Moves lights and camera up to this moment.
   * @param {number} now in milliseconds
   * @returns {boolean} whether they are moving
   */
  step(now) {
    const { lights, camera } = this.#tracks;
    for (const track of [lights, camera]) track.step(now);
    this.#scenes.seek(lights.seconds, camera.seconds);
    return this.isPlaying;
  }
}
