// The views of the page, one at a time. The address selects the view after its #.
import { follow, requestedView } from "./address.js";
import { element } from "./elements.js";
import { isTrap, sentence, words } from "./failure.js";
import { Frame } from "./frame.js";
import { built } from "./parts.js";

/** @typedef {{ show: (query: string) => void, hide: () => void, restore?: () => void }} Shown an opened view */
/**
 * What opens a view once its part of the demo is built.
 * @typedef {{ element: HTMLElement, part?: import("./parts.js").Name, open: () => Promise<Shown> }} Source
 */

/** A view that is opened when it is first requested. A failed opening can be retried. */
class View {
  #source;
  /** @type {Promise<Shown> | undefined} */
  #opening;
  /** @type {Shown | undefined} */
  #opened;

  /** What the view waits for, in words. */
  waits = "";

  /** Called when that has changed. */
  onwait = () => {};

  /** @param {Source} source */
  constructor(source) {
    this.#source = source;
    this.element = source.element;
  }

  /**
   * @param {string} query
   * @param {() => boolean} isWanted
   */
  async show(query, isWanted) {
    this.#opening ??= this.#open();
    try {
      this.#opened = await this.#opening;
    } catch (error) {
      this.#opening = undefined;
      throw error;
    }
    // The visitor may have left the view in the meantime.
    if (isWanted()) await this.#opened.show(query);
  }

  async #open() {
    const { part, open } = this.#source;
    try {
      if (part) await built(part, (text) => this.#wait(text));
      return await open();
    } finally {
      this.#wait("");
    }
  }

  /** @param {string} text */
  #wait(text) {
    if (text === this.waits) return;
    this.waits = text;
    this.onwait();
  }

  restore() {
    this.#opened?.restore?.();
  }

  hide() {
    this.element.hidden = true;
    this.#opened?.hide();
  }
}

/** The title of the page, which is that of the first view. */
const TITLE = document.title;

export class Views {
  #views;
  /** @type {string | undefined} */
  #chosen;
  #absent = element("absent");
  #reason = element("absent-reason");
  #waiting = element("waiting");

  /** Called when the chosen view waits for what is still being built. */
  onwait = () => {};

  /**
   * @param {Map<string, Source>} views by name; the first is shown if the address names none of them. `show` gets the
   *   state of the address
   */
  constructor(views) {
    this.#views = new Map([...views].map(([name, view]) => [name, new View(view)]));
    for (const [name, view] of this.#views) view.onwait = () => name === this.#chosen && this.#place(view);
    window.addEventListener("hashchange", ({ newURL }) => this.#follow(newURL));
    // A lost graphics processor takes the pictures of all canvases. The event does not bubble.
    const restoring = new Frame(() => this.#views.get(this.#chosen ?? "")?.restore());
    document.addEventListener("contextrestored", () => restoring.request(), true);
    element("absent-retry").addEventListener("click", () => this.show());
  }

  /**
   * Shows the view that the visitor has gone to, and leads the focus there. The view before may have
   * written its own address since.
   * @param {string} address
   */
  async #follow(address) {
    const before = this.#chosen;
    const shown = this.show(requestedView(new URL(address).hash));
    const view = this.#views.get(this.#chosen ?? "");
    if (view && this.#chosen !== before) lead(view.waits ? this.#waiting : view.element);
    await shown;
  }

  /**
   * Shows a view, or else the one in the address. A view that can't be shown is replaced by a
   * message.
   */
  async show({ name, query } = requestedView(location.hash)) {
    const [first] = this.#views.keys();
    const chosen = this.#views.has(name) ? name : /** @type {string} */ (first);
    const isWanted = () => this.#chosen === chosen;
    this.#chosen = chosen;
    follow(chosen);
    for (const [other, view] of this.#views) {
      if (other !== chosen && !view.element.hidden) view.hide();
    }
    for (const link of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll(".views a"))) {
      if (requestedView(link.hash).name === chosen) {
        link.setAttribute("aria-current", "page");
        document.title = chosen === first ? TITLE : `${link.textContent} – ${TITLE}`;
      } else link.removeAttribute("aria-current");
    }
    this.#absent.hidden = true;
    const view = /** @type {View} */ (this.#views.get(chosen));
    this.#place(view);
    try {
      await view.show(query, isWanted);
    } catch (error) {
      if (isTrap(error)) throw error;
      if (isWanted()) this.#tell(view, error);
    }
  }

  /**
   * Shows a view, or what it waits for.
   * @param {View} view
   */
  #place({ element, waits }) {
    const [shown, other] = waits ? [this.#waiting, element] : [element, this.#waiting];
    const hasFocus = other.contains(document.activeElement);
    this.#waiting.textContent = waits;
    element.hidden = waits !== "";
    if (hasFocus) lead(shown);
    if (waits) this.onwait();
  }

  /**
   * @param {View} view
   * @param {unknown} error
   */
  #tell(view, error) {
    const hasFocus = view.element.contains(document.activeElement);
    view.hide();
    this.#reason.textContent = `This view can't be shown: ${sentence(words(error))} The other views still work.`;
    this.#absent.hidden = false;
    if (hasFocus) lead(this.#absent);
  }
}

/**
 * Leads the focus to a part of the page.
 * @param {HTMLElement} part
 */
function lead(part) {
  part.tabIndex = -1;
  part.focus({ preventScroll: true });
}
