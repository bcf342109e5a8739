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

    // Where an element is on the page, in whole pixels.
    place(selector) {
      const found = document.querySelector(selector) ?? raise(`the page has no element ${selector}`);
      found.scrollIntoView({ block: "center" });
      const { x, y, width, height } = found.getBoundingClientRect();
      const [left, top] = [Math.round(x + scrollX), Math.round(y + scrollY)];
      return { x: left, y: top, width: Math.round(width), height: Math.round(height) };
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
