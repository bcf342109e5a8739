// Starts Chromium, by puppeteer-core, and the virtual display that some renderers and browsers need.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createRequire } from "node:module";

/** The folder of the npm packages, and the programs, as far as they are needed. */
const { MODULES, CHROMIUM, XVFB } = process.env;

export const puppeteer = createRequire(`${MODULES}/`)("puppeteer-core");

const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-dev-shm-usage",
  "--disable-sync",
  "--no-default-browser-check",
  "--no-first-run",
  "--no-proxy-server",
  // Only this machine's address is resolved, so that a page that needs the network fails at once.
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
  "about:blank",
];

/** How long a start or a call may take on a busy machine, in milliseconds. Starting takes far less. */
export const PATIENCE = 300_000;

/** Starts Chromium, by default as on a machine without a GPU. */
export const chromium = (flags = ["--disable-gpu"], env = {}) =>
  puppeteer.launch({
    executablePath: CHROMIUM,
    // Those of puppeteer keep a page at work that nobody sees.
    ignoreDefaultArgs: true,
    args: [...FLAGS, ...flags],
    env: { ...process.env, ...env },
    defaultViewport: null,
    timeout: PATIENCE,
    protocolTimeout: 0,
  });

/** Starts an X server that shows nothing. Returns its name, as in `:1`, and what ends it. */
export async function display() {
  const server = spawn(XVFB, ["-displayfd", "1", "-screen", "0", "2560x1600x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "pipe", "ignore"],
  });
  const [number] = await once(server.stdout, "data");
  return { name: `:${String(number).trim()}`, end: () => server.kill() };
}
