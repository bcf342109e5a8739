// The tabs of the desk. An arrow key, Home or End shows another panel, as a click does.
import { element } from "./elements.js";

const tabs = () => /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[role=tab]")]);

/** @param {HTMLElement} tab */
const panelOf = (tab) => element(/** @type {string} */ (tab.getAttribute("aria-controls")));

/** @param {HTMLElement} chosen */
function choose(chosen) {
  for (const tab of tabs()) {
    tab.setAttribute("aria-selected", String(tab === chosen));
    tab.tabIndex = tab === chosen ? 0 : -1;
    panelOf(tab).hidden = tab !== chosen;
  }
}

/** Shows the panel with a part of the desk. @param {Node} part */
export function reveal(part) {
  const holder = tabs().find((tab) => panelOf(tab).contains(part));
  if (holder) choose(holder);
}

/** Connects the tabs. */
export function joinTabs() {
  const all = tabs();
  choose(all[0]);
  for (const [at, tab] of all.entries()) {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      /** @type {Record<string, number>} */
      const ways = { ArrowRight: at + 1, ArrowLeft: at + all.length - 1, Home: 0, End: all.length - 1 };
      if (!(event.key in ways)) return;
      event.preventDefault();
      const next = all[ways[event.key] % all.length];
      choose(next);
      next.focus();
    });
  }
}
