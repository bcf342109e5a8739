// What the tests call in the page.

/** Runs in the page before its own scripts. */
export function probe() {
  // Upper bound of the polls of a wait: some minutes. On an idle machine a wait takes a fraction of a second.
  const TRIES = 2000;

  const pictures = new Map();
  let seen;
  const raise = (message) => { throw new Error(message); };
  const element = (id) => document.getElementById(id) ?? raise(`the page has no element #${id}`);
  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  const picture = (name) => pictures.get(name) ?? raise(`no picture was kept as ${name}`);

  // The next time at which the page may draw. A busy browser lets it wait for long, and a hidden page for ever.
  const frame = () => Promise.race([new Promise(requestAnimationFrame), pause(2000)]);

  // The lines of an element's own text, without those that a box around it cuts off.
  const lines = (node) =>
    [...node.childNodes].flatMap((child) => {
      if (child.nodeType !== Node.TEXT_NODE || !child.data.trim()) return [];
      const range = document.createRange();
      range.selectNode(child);
      return Array.from(range.getClientRects(), (box) => ({ node, box }));
    });

  // The width that the chosen option of a select needs, with its padding.
  const labelWidth = (select) => {
    const { font, paddingLeft, paddingRight } = getComputedStyle(select);
    const context = document.createElement("canvas").getContext("2d");
    context.font = font;
    return context.measureText(select.selectedOptions[0]?.label ?? "").width + parseFloat(paddingLeft) + parseFloat(paddingRight);
  };

  window.probe = {
    element,
    visible: (id) => element(id).checkVisibility({ visibilityProperty: true, opacityProperty: true }),
    sum: () => window.luminaire.pixels().reduce((sum, code) => (31 * sum + code) % 4294967291, 7),

    // Waits until the page has its styles, and has drawn nothing for a while in which it could have.
    async settle() {
      for (let tries = 0; tries < TRIES; tries += 1) {
        const { drawn } = window.luminaire;
        await pause(100);
        await frame();
        const isStyled = [...document.querySelectorAll("link[rel=stylesheet]")].every((link) => link.sheet);
        if (isStyled && window.luminaire.drawn === drawn && !window.luminaire.isDrawing) return;
      }
      raise("the page never stops drawing");
    },

    enter(id, value) {
      const input = element(id);
      input.focus();
      input.value = value;
      input.dispatchEvent(new Event("input", { bubbles: true }));
      input.dispatchEvent(new Event("change", { bubbles: true }));
    },

    // Presses a key on an element, as a keyboard does.
    key: (target, options) => target.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...options })),

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

    keep: (name) => void pictures.set(name, window.luminaire.pixels().slice()),

    // The largest difference of two kept pictures in displayed 8-bit codes, and the share of pixels that differ
    // visibly: by over 16 codes in some channel.
    differences(one, other) {
      const [a, b] = [picture(one), picture(other)];
      if (a.length !== b.length) raise(`${one} and ${other} differ in size`);
      let [largest, visible] = [0, 0];
      for (let i = 0; i < a.length; i += 4) {
        const difference = Math.max(...[0, 1, 2].map((channel) => Math.abs(a[i + channel] - b[i + channel])));
        largest = Math.max(largest, difference);
        if (difference > 16) visible += 1;
      }
      return { largest, share: visible / (a.length / 4) };
    },

    survey() {
      const pixels = window.luminaire.pixels();
      const colours = new Set();
      let lit = 0;
      for (let i = 0; i < pixels.length; i += 4) {
        const colour = (pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2];
        if (colour !== 0) lit += 1;
        colours.add(colour);
      }
      return { pixels: pixels.length / 4, lit: lit / (pixels.length / 4), colours: colours.size };
    },

    // The SHA-256 of the picture, in hexadecimal digits.
    async digest() {
      const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", window.luminaire.pixels()));
      return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
    },

    // What is seen in a PNG in base64: the most frequent colour; of the middle row the colours, and the share that does
    // not have that one; whether the top rows have another; and how many pixels differ from those before.
    async look(png) {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (byte) => byte.charCodeAt(0))]));
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const pixels = [...new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)];
      const row = pixels.slice(Math.floor(height / 2) * width).slice(0, width);
      const counts = new Map();
      for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
      const [[ground]] = [...counts].sort((one, other) => other[1] - one[1]);
      const isOther = (pixel) => pixel !== ground;
      const differing = seen?.filter((pixel, i) => pixel !== pixels[i]).length;
      seen = pixels;
      const share = row.filter(isOther).length / width;
      return { ground, colours: new Set(row).size, share, top: pixels.slice(0, 3 * width).some(isOther), differing, pixels: pixels.length };
    },

    // The colours of the map over the picture, as [red, green, blue, alpha].
    map() {
      const map = element("map");
      return map.getContext("2d").getImageData(0, 0, map.width, map.height).data;
    },
  };
}
