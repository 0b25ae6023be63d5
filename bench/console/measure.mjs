// How fast the operator console is, in a headless Chromium against a real mlab: first load, time from an event to the
// screen, frames per second and main-thread time for each. Prints JSON.
// `node bench/console/measure.mjs [seconds for each]`; needs `npm ci` in web/ and a built mlab (MLAB_COMMAND=FILE).
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { openBrowser } from "../../web/tools/browser.mjs";
import { root, round, size, startMlab, watchSocket } from "./real_mlab.mjs";

const seconds = Number(process.argv[2] ?? 10);

/** A mission in which `units` rows of `each` robots cross 3 km, side by side. Returns its path. */
function writeMission(folder, units, each) {
  const names = Array.from({ length: units }, (_, i) => i);
  const height = 3000 / units;
  const overlay = [
    "MISSION-AREA 3000 3000",
    "CONTROL MEASURES:",
    ...names.map((i) => `AA Start${i} 20 ${Math.round((i + 0.5) * height)} 10`),
    ...names.map((i) => `OBJ Goal${i} 2950 ${Math.round((i + 0.5) * height)} 10`),
  ];
  const robots = (names, text) => names.map(text).join(" ");
  const mission = [
    'MISSION NAME "Many"',
    "OVERLAY many.odl",
    'NEW-ROBOT small "robot" blue (base_velocity = 2, navigation_avoid_robot_sphere = 6, navigation_avoid_robot_min_range = 2)',
    `UNIT <all> ${robots(names, (i) => `(<u${i}>${" small".repeat(each)})`)}`,
    "COMMAND LIST:",
    ` 0. ${names.map((i) => `UNIT u${i} START Start${i} ${Math.floor(1000 / each)} 0`).join(" AND ")}`,
    ` 1. ${names.map((i) => `UNIT u${i} MOVETO Goal${i}`).join(" AND ")}`,
    " 2. UNIT all STOP",
  ];
  writeFileSync(join(folder, "many.odl"), `${overlay.join("\n")}\n`);
  const path = join(folder, "many.mdl");
  writeFileSync(path, `${mission.join("\n")}\n`);
  return path;
}

async function openConsole(browser, url) {
  const page = await browser.page(size);
  page.setDefaultTimeout(120_000);
  await page.addInitScript(watchSocket);
  await page.goto(url);
  await page.getByTestId("run-state").filter({ hasText: "Ready" }).waitFor();
  return page;
}

/** In the page: when the Execute button and the map have been drawn [ms since the address was called]. */
function noteReady() {
  const look = (at) => {
    const button = document.querySelector("[data-testid=main-button]")?.textContent ?? "";
    if (/Execute/.test(button) && document.querySelector(".map canvas")) window.readyAt = at;
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** From the page's address to the mission, its map and the Execute button, in ms: a browser without any cache. */
async function measureLoad() {
  const folder = mkdtempSync(join(tmpdir(), "mlab-bench-"));
  const times = [];
  for (let tries = 0; tries < 5; ++tries) {
    const mlab = await startMlab(folder, "run", join(root, "missions", "demo_c", "demo_c.mdl"));
    const browser = await openBrowser();
    const page = await browser.page(size);
    await page.addInitScript(noteReady);
    await page.goto(mlab.url);
    await page.getByTestId("main-button").filter({ hasText: "Execute" }).waitFor();
    while (times.length === tries) {
      const at = await page.evaluate(() => window.readyAt ?? 0);
      if (at > 0) times.push(at);
    }
    await browser.close();
    await mlab.stop();
  }
  rmSync(folder, { recursive: true, force: true });
  return { "first load, best of five [ms]": round(Math.min(...times)), "all [ms]": times.map(round) };
}

async function setSpeed(page, speed) {
  await page.getByRole("button", { name: /^Speed / }).click();
  const dialog = page.getByRole("dialog", { name: "Speed" });
  await dialog.getByRole("button", { name: speed, exact: true }).click();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
}

/** Frames drawn, and the main thread's time for each: all that it did, not only drawing. */
async function measureFrames(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const busy = async () =>
    (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const results = [];
  for (let tries = 0; tries < 3; ++tries) {
    await page.evaluate(() => window.noted.drawn.splice(0));
    const before = await busy();
    const begin = Date.now();
    await page.waitForTimeout(seconds * 1000);
    const frames = await page.evaluate(() => window.noted.drawn.length);
    const time = (Date.now() - begin) / 1000;
    const spent = (await busy()) - before;
    results.push({
      "frames per second": round(frames / time),
      "main thread per frame [ms]": round((1000 * spent) / frames),
    });
  }
  results.sort((a, b) => b["frames per second"] - a["frames per second"]);
  return { "best of three": results[0], all: results };
}

/** With the run paused, a key asks for one cycle: until its frame, with every robot in a new place, is drawn. */
async function measureEvents(page) {
  await page.getByTestId("main-button").click();
  await page.getByTestId("run-state").filter({ hasText: "Paused" }).waitFor();
  await page.waitForTimeout(500);
  const times = [];
  for (let turn = 0; turn < 30 * seconds; ++turn) {
    const took = await page.evaluate(async () => {
      const { drawn } = window.noted;
      const known = drawn.length;
      const begin = Date.now();
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "c", code: "KeyC", bubbles: true }));
      while (drawn.length === known && Date.now() - begin < 5000) await new Promise((go) => setTimeout(go, 1));
      return (drawn[known] ?? Number.POSITIVE_INFINITY) - begin;
    });
    times.push(took);
    await page.waitForTimeout(30);
  }
  times.sort((a, b) => a - b);
  const at = (share) => round(times[Math.min(times.length - 1, Math.floor(share * times.length))]);
  return { events: times.length, "median [ms]": at(0.5), "99th percentile [ms]": at(0.99), "longest [ms]": at(1) };
}

const results = { "load of the machine": loadavg()[0] };
results.load = await measureLoad();
for (const [robots, units, speed] of [
  [1000, 25, "×10"],
  [10000, 100, "×5"],
]) {
  const folder = mkdtempSync(join(tmpdir(), "mlab-bench-"));
  const mlab = await startMlab(folder, "run", writeMission(folder, units, robots / units));
  const browser = await openBrowser();
  const page = await openConsole(browser, mlab.url);
  await setSpeed(page, speed);
  await page.getByTestId("main-button").click();
  await page.getByTestId("run-state").filter({ hasText: "Running" }).waitFor();
  await page.waitForTimeout(3000);
  results[`${robots} robots`] = { frames: await measureFrames(page) };
  if (robots === 1000) {
    results[`${robots} robots`]["event to screen"] = await measureEvents(page);
  }
  await page.screenshot({ path: join(tmpdir(), `console_bench_${robots}.png`) });
  await browser.close();
  await mlab.stop();
  rmSync(folder, { recursive: true, force: true });
}
results["load of the machine afterwards"] = loadavg()[0];
console.log(JSON.stringify(results, null, 2));
