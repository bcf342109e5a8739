// WebKitGTK, which puppeteer cannot drive: a page of it by WebDriver, as far as the tests of that engine need it.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import { fileURLToPath } from "node:url";

import { PATIENCE, display } from "../../../xtask/browser/launch.mjs";

const { PYTHON, WEBKIT_DRIVER } = process.env;

/** The browser, which the driver starts. */
const HOST = fileURLToPath(new URL("webkit.py", import.meta.url));

/** A port that nothing listens on. Another program may take it first. */
function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** Starts the display, the driver and the browser. */
export async function webkit() {
  const [screen, folder, port] = [await display(), mkdtempSync(join(tmpdir(), "webkit-")), await freePort()];
  const prelude = join(folder, "prelude.js");
  writeFileSync(prelude, "");
  const env = { ...process.env, DISPLAY: screen.name, GDK_BACKEND: "x11", NO_AT_BRIDGE: "1" };
  const driver = spawn(WEBKIT_DRIVER, [`--port=${port}`], { env, stdio: "ignore" });
  let session = `http://127.0.0.1:${port}`;
  const call = async (method, path, body) => {
    const response = await fetch(session + path, { method, body: body && JSON.stringify(body) });
    const { value } = await response.json();
    if (value?.error) throw new Error(`WebKit refuses ${path}: ${value.error} ${value.message}`);
    return value;
  };
  for (const end = Date.now() + PATIENCE; ; await pause(50)) {
    if (await call("GET", "/status").catch(() => false)) break;
    if (Date.now() > end) throw new Error("WebKitWebDriver does not start");
  }
  const options = { binary: PYTHON, args: [HOST, folder] };
  const alwaysMatch = { pageLoadStrategy: "eager", "webkitgtk:browserOptions": options };
  const { sessionId } = await call("POST", "/session", { capabilities: { alwaysMatch } });
  session = `${session}/session/${sessionId}`;
  await call("POST", "/timeouts", { script: PATIENCE, pageLoad: PATIENCE });
  // A window is opened from another one: the first, which stays blank.
  const first = await call("GET", "/window");
  let windows = 1;

  async function newPage() {
    await call("POST", "/window", { handle: first });
    const number = windows++;
    const scripts = [];
    const listeners = {};
    let read = 0;
    let at;
    /** Tells the listeners what the browser has logged of this window. */
    const listen = () => {
      const lines = readFileSync(join(folder, "log.jsonl"), "utf8").split("\n").slice(0, -1).map((line) => JSON.parse(line));
      for (const { window, request, complaint } of lines.slice(read)) {
        if (window !== number) continue;
        if (request) listeners.request({ url: () => request });
        if (complaint) listeners.pageerror(complaint);
      }
      read = lines.length;
    };
    const evaluate = async (act, ...given) => {
      // As JSON, because the driver refuses values such as typed arrays.
      const expression = typeof act === "string" ? `(${act})` : `(${act})(...${JSON.stringify(given)})`;
      const script = `const done = arguments[0];
        (async () => ${expression})().then((value) => done(JSON.stringify({ value })), (error) => done(JSON.stringify({ error: String(error) })));`;
      const { value, error } = JSON.parse(await call("POST", "/execute/async", { script, args: [] }));
      listen();
      if (error) throw new Error(`the page threw ${error}`);
      return value;
    };
    const act = (actions) => call("POST", "/actions", { actions: [{ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions }] });
    const move = (x, y) => ({ type: "pointerMove", x: Math.round(x), y: Math.round(y), duration: 0 });
    return {
      evaluate,
      on: (event, act) => (listeners[event] = act),
      evaluateOnNewDocument: (script) => scripts.push(typeof script === "string" ? script : `(${script})()`),
      setViewport: () => {},
      async goto(url) {
        writeFileSync(prelude, scripts.map((script) => `${script};\n`).join(""));
        const { handle } = await call("POST", "/window/new", { type: "window" });
        await call("POST", "/window", { handle });
        await call("POST", "/window/rect", { width: 1440, height: 900 });
        await call("POST", "/url", { url });
      },
      mouse: {
        move: async (x, y, { steps = 1 } = {}) => {
          const way = at ? [x - at[0], y - at[1]] : [0, 0];
          const from = at ?? [x, y];
          const share = (_, step) => move(from[0] + (way[0] * (step + 1)) / steps, from[1] + (way[1] * (step + 1)) / steps);
          await act(Array.from({ length: steps }, share));
          at = [x, y];
        },
        down: () => act([{ type: "pointerDown", button: 0 }]),
        up: () => act([{ type: "pointerUp", button: 0 }]),
      },
      close: () => call("DELETE", "/window"),
    };
  }

  return {
    createBrowserContext: async () => {
      const page = await newPage();
      return { newPage: () => page, close: page.close };
    },
    /** The driver ends the session when a page's process has crashed. */
    hasCrashed: () => call("GET", "/timeouts").then(() => false, () => true),
    async close() {
      await call("DELETE", "").catch(() => {});
      driver.kill();
      screen.end();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
