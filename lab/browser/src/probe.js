// The functions that the tests call in the page: they act as a visitor would, and compare pictures inside the page.
window.probe = (() => {
  "use strict";

  // Upper bound of the polls of a wait: some minutes. On an idle machine a wait takes a fraction of a second.
  const TRIES = 6000;

  const pictures = new Map();
  const element = (id) => document.getElementById(id) ?? raise(`the page has no element #${id}`);
  const raise = (message) => { throw new Error(message); };
  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  const picture = (name) => pictures.get(name) ?? raise(`no picture was kept as ${name}`);

  // The next time at which the page may draw. A busy browser lets it wait for long, and a hidden page for ever.
  const frame = () => Promise.race([new Promise(requestAnimationFrame), pause(2000)]);

  // The page has settled when it has drawn nothing for a while, in which it could have.
  async function settle() {
    for (let tries = 0; tries < TRIES; tries += 1) {
      const drawn = luminaire.drawn;
      await pause(150);
      await frame();
      if (luminaire.drawn === drawn && !luminaire.isDrawing) return;
    }
    raise("the page never stops drawing");
  }

  // Waits until the page has drawn more than `drawn` pictures, and then until it has settled.
  async function redrawn(drawn) {
    for (let tries = 0; luminaire.drawn === drawn; tries += 1) {
      if (tries > TRIES) raise("the page draws no new picture");
      await pause(20);
    }
    await settle();
  }

  // Waits until `holds()` returns true.
  async function until(holds) {
    for (let tries = 0; !holds(); tries += 1) {
      if (tries > TRIES) raise(`it does not come to be that ${holds}`);
      await pause(20);
    }
  }

  // The lines of an element's own text, without those that a box around it cuts off.
  function lines(node) {
    return [...node.childNodes].flatMap((child) => {
      if (child.nodeType !== Node.TEXT_NODE || !child.data.trim()) return [];
      const range = document.createRange();
      range.selectNode(child);
      return Array.from(range.getClientRects(), (box) => ({ node, box }));
    });
  }

  // The width that the chosen option of a select needs, with its padding.
  function labelWidth(select) {
    const { font, paddingLeft, paddingRight } = getComputedStyle(select);
    const context = document.createElement("canvas").getContext("2d");
    context.font = font;
    return context.measureText(select.selectedOptions[0]?.label ?? "").width + parseFloat(paddingLeft) + parseFloat(paddingRight);
  }

  return {
    settle,
    redrawn,
    until,
    value: (id) => Number(element(id).value),
    least: (id) => Number(element(id).min),
    greatest: (id) => Number(element(id).max),
    text: (id) => element(id).textContent.trim(),
    options: (id) => Array.from(element(id).options, (option) => option.value),
    visible: (id) => element(id).checkVisibility({ visibilityProperty: true, opacityProperty: true }),

    enter(id, value) {
      const input = element(id);
      input.focus();
      input.value = value;
      input.dispatchEvent(new Event("input", { bubbles: true }));
      input.dispatchEvent(new Event("change", { bubbles: true }));
    },

    // Presses a key on an element, as a keyboard does.
    key(target, options) {
      target.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...options }));
    },

    // The middle of an element, in the page's pixels.
    middle(id) {
      element(id).scrollIntoView({ block: "center" });
      const box = element(id).getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    },

    // Where an element with a margin is on the page, in whole pixels.
    place(selector, margin = 0) {
      const found = document.querySelector(selector) ?? raise(`the page has no element ${selector}`);
      found.scrollIntoView({ block: "center" });
      const { x, y, width, height } = found.getBoundingClientRect();
      const [left, top] = [x + scrollX, y + scrollY].map((side) => Math.max(0, Math.round(side) - margin));
      return { x: left, y: top, width: Math.round(width) + 2 * margin, height: Math.round(height) + 2 * margin };
    },

    // What of the page is cut, covered or beside the window, in words.
    misplaced() {
      // Above the place from which on the picture stays over what is scrolled.
      scrollTo(0, 0);
      const faults = [];
      const shown = (node) => node.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && !node.closest(".unseen");
      const named = (node) => `${node.localName}${node.id && `#${node.id}`} "${node.textContent.trim().slice(0, 40)}"`;
      const style = (node) => getComputedStyle(node);
      const scrolls = (node) => node && node !== document.body && (/auto|scroll/.test(style(node).overflow) || scrolls(node.parentElement));
      if (document.documentElement.scrollWidth > innerWidth) faults.push(`the page is ${document.documentElement.scrollWidth} pixels wide`);
      const texts = [];
      for (const node of document.querySelectorAll("body *")) {
        if (!shown(node) || scrolls(node)) continue;
        const isText = [...node.childNodes].some((child) => child.nodeType === Node.TEXT_NODE && child.data.trim());
        if (!isText && !node.matches("input, select, button, canvas, svg")) continue;
        const { left, right } = node.getBoundingClientRect();
        if (left < -0.5 || right > innerWidth + 0.5) faults.push(`${named(node)} is beside the window`);
        if (isText && style(node).overflow !== "visible" && node.scrollWidth > node.clientWidth + 1) faults.push(`${named(node)} is cut`);
        if (node.localName === "select" && labelWidth(node) > node.clientWidth) faults.push(`${named(node.selectedOptions[0])} is cut in #${node.id}`);
        if (isText && !node.closest("svg, select, datalist")) texts.push(...lines(node));
      }
      for (const [i, one] of texts.entries()) {
        for (const other of texts.slice(i + 1)) {
          const width = Math.min(one.box.right, other.box.right) - Math.max(one.box.left, other.box.left);
          const height = Math.min(one.box.bottom, other.box.bottom) - Math.max(one.box.top, other.box.top);
          if (width > 2 && height > 4) faults.push(`${named(one.node)} is over ${named(other.node)}`);
        }
      }
      return faults;
    },

    keep(name) {
      pictures.set(name, luminaire.pixels().slice());
    },

    // The largest difference between two kept pictures, in displayed 8-bit codes.
    difference(one, other) {
      const [a, b] = [picture(one), picture(other)];
      if (a.length !== b.length) raise(`${one} and ${other} differ in size`);
      let largest = 0;
      for (let i = 0; i < a.length; i += 1) largest = Math.max(largest, Math.abs(a[i] - b[i]));
      return largest;
    },

    // The share of pixels that differ visibly in two kept pictures: by over 16 codes in some channel.
    share(one, other) {
      const [a, b] = [picture(one), picture(other)];
      if (a.length !== b.length) raise(`${one} and ${other} differ in size`);
      let visible = 0;
      for (let i = 0; i < a.length; i += 4) {
        if ([0, 1, 2].some((channel) => Math.abs(a[i + channel] - b[i + channel]) > 16)) visible += 1;
      }
      return visible / (a.length / 4);
    },

    // The SHA-256 of the picture, in hexadecimal digits.
    async digest() {
      const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", luminaire.pixels()));
      return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
    },

    // The share of pixels brighter than black, and the number of distinct colours.
    survey() {
      const pixels = luminaire.pixels();
      const colours = new Set();
      let lit = 0;
      for (let i = 0; i < pixels.length; i += 4) {
        const colour = (pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2];
        if (colour !== 0) lit += 1;
        colours.add(colour);
      }
      return { pixels: pixels.length / 4, lit: lit / (pixels.length / 4), colours: colours.size };
    },
  };
})();
