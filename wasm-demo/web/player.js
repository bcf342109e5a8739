// The switches that make the lamps of a scene move, and its camera.

/** A switch, and how long what it moves has been moving. */
class Track {
  #switch;
  #last;

  /** For how long it has been moving. */
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

  /** Begins at rest; without anything to move the switch can't be switched. */
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

  /** Called when something starts to move, or stops. */
  onchange = () => {};

  constructor(scenes) {
    this.#scenes = scenes;
    const track = (id) => new Track(id, () => this.onchange());
    this.#tracks = { lamps: track("scene-play"), camera: track("scene-camera") };
  }

  /** Whether anything moves by itself. */
  get isPlaying() {
    return this.#tracks.lamps.isPlaying || this.#tracks.camera.isPlaying;
  }

  /** Makes ready for the scene that was opened. What played goes on playing, from the beginning. */
  open() {
    const moves = { lamps: this.#scenes.moves(), camera: this.#scenes.cameraMoves() };
    for (const [name, track] of Object.entries(this.#tracks)) track.open(moves[name]);
    this.#note.hidden = moves.lamps || moves.camera;
  }

  /** Stops everything where it is. */
  stop() {
    for (const track of Object.values(this.#tracks)) track.stop();
  }

  /**
   * Moves lamps and camera up to this moment.
   * @param {number} now in milliseconds
   * @returns {boolean} whether they are moving
   */
  step(now) {
    const { lamps, camera } = this.#tracks;
    for (const track of [lamps, camera]) track.step(now);
    this.#scenes.seek(lamps.seconds, camera.seconds);
    return this.isPlaying;
  }
}
