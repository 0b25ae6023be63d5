// How fast a recording is opened and scrubbed in the console, in a headless Chromium against a real `mlab replay`: from the
// command to the first picture, and pictures that reach the screen while the time line is dragged. Prints JSON.
// `node bench/console/time_line.mjs`; needs `npm ci` in web/ and a built mlab (MLAB_COMMAND=FILE).
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { openBrowser } from "../../web/tools/browser.mjs";
import { command, round, size, startMlab, watchSocket } from "./real_mlab.mjs";

/** Units of so many standard robots each, which go to and fro between rocks. Returns the mission's path. */
function writeMission(folder, units, each, steps) {
  const names = Array.from({ length: units }, (_, i) => i);
  const x = (i) => 150 + 300 * (i % 8);
  const y = (i) => 150 + 440 * Math.floor(i / 8);
  const all = (text) => names.map(text).join(" AND\n     ");
  const overlay = names.flatMap((i) => [
    `OBJ S${i} ${x(i)} ${y(i)} 100`,
    `OBJ G${i} ${x(i)} ${y(i) + 260} 100`,
    `OBSTACLE ${x(i) + 10} ${y(i) + 140} 6`,
  ]);
  writeFileSync(join(folder, "map.odl"), `MISSION-AREA 2400 2400\nCONTROL MEASURES:\n${overlay.join("\n")}\n`);
  const go = (i, to, formation) => `UNIT u${i} MOVETO OBJ-${to}${i} FORMATION ${formation}`;
  const mission = [
    "OVERLAY map.odl",
    ...names.map((i) => `UNIT <u${i}>${" ROBOT".repeat(each)}`),
    "COMMAND LIST:",
    `  0. ${all((i) => `UNIT u${i} START OBJ-S${i} 0 10`)}`,
    ...Array.from({ length: steps }, (_, step) =>
      step % 2 === 0
        ? `  ${step + 1}. ${all((i) => go(i, "G", "Wedge"))}`
        : `  ${step + 1}. ${all((i) => go(i, "S", "Column"))}`,
    ),
  ];
  const path = join(folder, "many.mdl");
  writeFileSync(path, `${mission.join("\n")}\n`);
  return path;
}

function record(mission, path, time) {
  const options = ["--headless", "--quiet", "--proceed", "--limit", String(time), "--record", path];
  const { status, stderr } = spawnSync(command, ["run", mission, ...options], { encoding: "utf8" });
  // 3: ended by its limit
  if (status !== 0 && !stderr.includes("interrupted") && statSync(path, { throwIfNoEntry: false }) === undefined)
    throw new Error(`mlab ended with ${status}:\n${stderr}`);
}

/** Processor time that a process has had so far [s]. */
function processorTime(pid) {
  const [user, system] = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ").slice(11, 13);
  return (Number(user) + Number(system)) / 100;
}

/** Where the time line shows that the run is [s]. */
const moment = (page) => page.getByRole("slider", { name: "Moment of the run" }).getAttribute("aria-valuenow").then(Number);

/** Processor time of the page's main thread so far [s], whatever else the machine does. */
async function mainThread(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () =>
    (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
}

/** Drags along the line and back, a step for each frame of the display: pictures that were drawn, and that differ. */
async function measureScrubbing(page, pid, busy, seconds) {
  const box = await page.getByRole("slider", { name: "Moment of the run" }).boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 0.1 * box.width, y);
  await page.mouse.down();
  await page.evaluate(() => {
    window.noted.drawn.splice(0);
    window.shown = new Set();
    const look = () => {
      window.shown.add(document.querySelector("[data-testid=run-time]")?.textContent ?? "");
      requestAnimationFrame(look);
    };
    look();
  });
  const [busyBefore, servedBefore, begin] = [await busy(), processorTime(pid), Date.now()];
  for (let passed = 0; passed < seconds; passed = (Date.now() - begin) / 1000) {
    const share = 0.1 + 0.8 * Math.abs(1 - ((2 * passed) / seconds));
    await page.mouse.move(box.x + share * box.width, y);
    await page.waitForTimeout(10);
  }
  const time = (Date.now() - begin) / 1000;
  const [frames, moments] = await page.evaluate(() => [window.noted.drawn.length, window.shown.size]);
  const [drawn, served] = [(await busy()) - busyBefore, processorTime(pid) - servedBefore];
  await page.mouse.up();
  return {
    "processor time of the main thread per picture [ms]": round((1000 * drawn) / frames),
    "processor time of mlab per picture [ms]": round((1000 * served) / frames),
    "pictures per second": round(frames / time),
    "moments per second": round(moments / time),
  };
}

const results = { "load of the machine": loadavg()[0] };
for (const [name, units, each, time] of [
  ["10 robots, an hour", 2, 5, 3600],
  ["1,000 robots, ten minutes", 40, 25, 600],
]) {
  const folder = mkdtempSync(join(tmpdir(), "mlab-bench-"));
  const path = join(folder, "run.mcap");
  record(writeMission(folder, units, each, 120), path, time);
  const browser = await openBrowser();
  const page = await browser.page(size);
  page.setDefaultTimeout(120_000);
  await page.addInitScript(watchSocket);
  const busy = await mainThread(page);
  const begin = Date.now();
  const mlab = await startMlab(folder, "replay", path);
  const listens = Date.now();
  await page.goto(mlab.url);
  await page.waitForFunction(() => window.noted.drawn.length > 0, undefined, { polling: 10 });
  const first = Date.now();
  const opened = await busy();
  // All of it has been computed once where the end is shown.
  await page.getByRole("textbox", { name: "Time that is shown" }).fill(String(time));
  await page.keyboard.press("Enter");
  while ((await moment(page)) < time - 1) await page.waitForTimeout(20);
  await page.waitForFunction(
    (text) => document.querySelector("[data-testid=run-time]")?.textContent?.includes(text),
    time >= 3600 ? "1:00:00" : "10:00",
    { polling: 20 },
  );
  results[name] = {
    "bytes": statSync(path).size,
    "from the command to its address [ms]": listens - begin,
    "to the first picture [ms]": first - begin,
    "processor time of the main thread until then [ms]": round(1000 * opened),
    "until its end is shown [ms]": Date.now() - first,
    "scrubbing": await measureScrubbing(page, mlab.pid, busy, 10),
  };
  await page.screenshot({ path: join(tmpdir(), `time_line_bench_${units * each}.png`) });
  await browser.close();
  await mlab.stop();
  rmSync(folder, { recursive: true, force: true });
}
results["load of the machine afterwards"] = loadavg()[0];
console.log(JSON.stringify(results, null, 2));
