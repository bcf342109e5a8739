// The picture is drawn by workers: by any number of them with the same bits, or by the page itself, never so that the
// page is in the way of its visitor, and without more and more memory.
import {
  VIEWS, ask, assert, change, draws, enter, long, more, must, open, pause, press, quick, settle, shows, sum, tab, until, words,
} from "./visit.mjs";

/** Pictures that need all passes: with haze, gobos, shadows, dither, fixed point and maps. */
const PICTURES = [
  "scene=show&at=2.5/0&effects=dither",
  "scene=three-point&format=fx16&effects=haze/dither",
  "scene=gallery&map=lights&view=0.4/0.1/0.8",
  "scene=turntable&format=fx32&effects=shadow&map=tiles&at=0.7/0.3",
];

/** Sums of the picture, of its map and of its account. */
const sums = () =>
  ask(() => {
    const sum = (codes) => codes.reduce((sum, code) => (31 * sum + code) % 4294967291, 7);
    return [window.probe.sum(), document.getElementById("map").hidden || sum(window.probe.map()), JSON.stringify(window.luminaire.account)].join();
  });

more("any number of workers draws the same bits", async () => {
  for (const picture of PICTURES) {
    let expected;
    for (const workers of [0, 1, 2, 4]) {
      await open(`?width=320&height=200&workers=${workers}#stage?play=none&${picture}`);
      const found = [await sums()];
      for (const id of ["light-1-on", "effect-specular", "light-1-on"]) {
        await press(id);
        await settle();
        found.push(await sums());
      }
      expected ??= found;
      assert.deepEqual(found, expected, `${picture}, by ${workers} workers`);
    }
  }
});

quick("the page draws by itself where workers do not start", async () => {
  const address = "?width=320&height=200#stage?play=none&scene=three-point";
  await open(address);
  const expected = await sums();
  for (const script of [
    "window.Worker = undefined",
    "window.Worker = class extends Worker { constructor() { super('/no-such-script.js', { type: 'module' }) } }",
  ]) {
    await open(address, { script });
    assert.equal(await sums(), expected, script);
    await change("a beam, without workers", () => enter("light-beam-number", 12));
    assert.deepEqual([await shows("failure"), await shows("trouble")], [false, false], script);
    await until(() => window.probe.visible("scene-show"));
  }
}, { fails: true });

/**
 * A browser whose workers can be ended as it ends them for want of memory: no event tells that. Those of the picture are the
 * only two that share one. Those that are ruined end when they get this order. By then they have answered that they hold
 * their lock, which is the first that they answer: of one that ends before, nothing can be known.
 */
const KEEPS = `
  window.workers = [];
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = async function (message, ...given) {
    if (message.act === "hold") this.answered = new Promise((resolve) => this.addEventListener("message", resolve, { once: true }));
    if (message.act === "open" && message.count === 2) window.workers.push(this);
    if (message.act !== window.ruined) return postMessage.call(this, message, ...given);
    await this.answered;
    this.terminate();
  };`;

quick("workers that end are replaced, or the page says that they end", async () => {
  await open("?width=320&height=200&workers=2#stage?play=none&scene=three-point", { script: KEEPS });
  const expected = await sum();
  // While nothing is drawn, and while a picture is being drawn.
  await ask(() => window.workers[0].terminate());
  await until(() => window.workers.length === 4);
  for (let step = 0; step < 2; step += 1) await change("a light", () => press("light-1-on"));
  assert.equal(await sum(), expected);
  await ask(() => {
    document.getElementById("light-1-on").click();
    requestAnimationFrame(() => setTimeout(() => window.workers[3].terminate()));
  });
  await until(() => window.workers.length === 6);
  await settle();
  await change("a light", () => press("light-1-on"));
  assert.deepEqual([await sum(), await words("stage-error"), await shows("trouble")], [expected, "", false]);
  // Each one that starts ends before it has drawn, or before it could draw.
  for (const act of ["draw", "open"]) {
    await ask((act) => {
      window.ruined = act;
      window.workers.at(-1).terminate();
      document.getElementById("light-1-on").click();
    }, act);
    await until(() => document.getElementById("stage-error").textContent);
    assert.match(await words("stage-error"), /^The browser has ended what draws, 3 times: expected memory for 2 workers\./);
    // The next picture has its own attempts.
    await ask(() => (window.ruined = undefined));
    await press("light-1-on");
    await settle();
    for (let step = 0; step < 2; step += 1) await change("a light", () => press("light-1-on"));
    assert.deepEqual([await sum(), await words("stage-error")], [expected, ""]);
  }
});

/** Drags a slider from a value on. */
const slide = (id, from) =>
  ask(async (id, from) => {
    const before = window.luminaire.drawn;
    const pause = () => new Promise((resolve) => setTimeout(resolve, 20));
    for (let i = 0; i < 20; i += 1) {
      window.probe.enter(id, from + 0.02 * i);
      await pause();
    }
    while (window.luminaire.drawn <= before + 3) await pause();
  }, id, from);

/** The processor time in milliseconds of each task of the page's main thread, which other work does not lengthen. */
async function tasks(act) {
  await tab.tracing.start({ categories: ["toplevel"] });
  await act();
  const { traceEvents: events } = JSON.parse(new TextDecoder().decode(await tab.tracing.stop()));
  const thread = ({ pid, tid }) => `${pid} ${tid}`;
  const main = new Set(events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain").map(thread));
  const times = events.filter((event) => event.name === "ThreadControllerImpl::RunTask" && main.has(thread(event))).map(({ tdur }) => tdur / 1000);
  return times.filter((time) => time >= 0);
}

/** Fails if a task of a view takes longer than 50 ms of the processor while a visitor acts. */
async function isFree(view, act) {
  const longest = [];
  // A processor that others share, too, loses some of its speed.
  for (let attempt = 0; attempt < 5; attempt += 1) {
    await open(`?${view}`, { plays: true });
    const times = await tasks(act);
    must(times.length, (count) => count > 20, `${view}: over 20 tasks`);
    longest.push(Math.max(...times));
    if (longest.at(-1) <= 50) return;
  }
  must(longest, () => false, `${view}: no task longer than 50 ms`);
}

const ACTS = {
  "": async () => (await draws(20), slide("light-beam", 0.3)),
  "#compare?left=fx16&half=10": () => slide("half-angle", 0.8),
  "#museum": () => slide("exhibit-value", 0.1),
  "#chip": () => until(() => window.luminaire.chip?.drawn > 1),
};

quick("no task of the page takes longer than 50 ms", () => isFree("", ACTS[""]), { only: "Chromium" });

long("no task of the other views takes longer than 50 ms", async () => {
  for (const view of Object.keys(ACTS).filter((view) => VIEWS.includes(view.match(/\w+/)?.[0]))) await isFree(view, ACTS[view]);
});

long("five minutes of the show take no more memory", async () => {
  await open("?width=320&height=180#stage?scene=show", { plays: true });
  const client = await tab.createCDPSession();
  await client.send("Performance.enable");
  /** What is in use after all garbage is collected. */
  const measure = async () => {
    for (let i = 0; i < 3; i += 1) await client.send("HeapProfiler.collectGarbage");
    const { metrics } = await client.send("Performance.getMetrics");
    const [nodes, listeners, heap] = ["Nodes", "JSEventListeners", "JSHeapUsedSize"].map((wanted) => metrics.find(({ name }) => name === wanted).value);
    const [modules, pictures] = await ask(async () => [await window.luminaire.memory(), window.luminaire.drawn]);
    return { nodes, listeners, heap, modules, pictures };
  };
  await press("tab-price");
  // Until the browser has compiled its scripts.
  await pause(30_000);
  const before = await measure();
  await pause(300_000);
  const after = await measure();
  must([before, after], () => after.pictures > before.pictures + 300, "a show that plays");
  const isSame = after.nodes - before.nodes < 100 && before.listeners === after.listeners && before.modules === after.modules;
  must([before, after], () => isSame && after.heap - before.heap < 200_000, "the same memory");
});
