// The views of the page, one at a time: which of them, the address says after its #.

/** What stands after the #: the name of a view and, behind a question mark, what it is asked for. */
function requestedView(hash) {
  const [name, query = ""] = hash.slice(1).split("?");
  return { name, query: new URLSearchParams(query) };
}

export class Views {
  #views;

  /**
   * @param {Map<string, {element: HTMLElement, show: Function, hide: Function}>} views by name; the first is
   *   shown where the address names none of them. `show` is given what else the address says
   */
  constructor(views) {
    this.#views = views;
    window.addEventListener("hashchange", () => this.show());
  }

  /** Shows the view that the address asks for; answers what its `show` does. */
  show() {
    const { name, query } = requestedView(location.hash);
    const [first] = this.#views.keys();
    const chosen = this.#views.has(name) ? name : first;
    for (const [other, { element, hide }] of this.#views) {
      if (other === chosen || element.hidden) continue;
      element.hidden = true;
      hide();
    }
    for (const link of document.querySelectorAll(".views a")) {
      if (link.hash === `#${chosen}`) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    const view = this.#views.get(chosen);
    view.element.hidden = false;
    return view.show(query);
  }
}
