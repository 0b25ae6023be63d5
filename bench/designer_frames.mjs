// How fluid the designer is in a real browser: the time to the first drawing, and how long frames take while a person moves
// the canvas, zooms and drags a node, also while robots run it: with what the simulator sends meanwhile, and what it sends
// while another page is shown. Once as a whole, from far away, and once near; each figure with the nodes and wires that were
// in sight: where one is missing it ends with an error. `node bench/designer_frames.mjs [NODES...]`; MLAB_COMMAND is the mlab.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { openBrowser } from "../web/tools/browser.mjs";
import { wiresInSight } from "../web/tools/wires.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const command = process.env.MLAB_COMMAND ?? join(root, "build", "test", "bin", "mlab");
const counts = process.argv.slice(2).map(Number);
const size = { width: 1920, height: 1080 };

/** An assemblage of about so many nodes: sums of a noise and two that keep off things, and one sum of all. */
function configuration(nodes) {
  const groups = Math.max(1, Math.round((nodes - 1) / 6));
  const lines = ["assemblage Many() {", "  cooperate {"];
  for (let i = 0; i < groups; ++i) {
    const sense = `sense_obstacles(range = ${1 + (i % 9)} m)`;
    lines.push(
      "    1: cooperate {",
      `      1: Noise(persistence = ${1 + (i % 20)} s);`,
      `      0.5: AvoidStaticObstacles(readings = ${sense}, sphere = 1 m, safety_margin = 0.5 m);`,
      `      0.8: Probe(readings = ${sense});`,
      "    };",
    );
  }
  return [...lines, "  }", "}", ""].join("\n");
}

async function start(folder, file) {
  const mlab = spawn(command, ["edit", file, "--no-browser", "--port", "0", "--project", folder], {
    stdio: ["ignore", "pipe", "pipe"],
    env: { ...process.env, XDG_STATE_HOME: folder },
  });
  let output = "";
  for (const stream of [mlab.stdout, mlab.stderr]) stream.on("data", (bytes) => (output += bytes));
  for (let tries = 0; tries < 600; ++tries) {
    const url = /https?:\/\/\S+/.exec(output)?.[0];
    if (url) return { mlab, url };
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error(`mlab did not start:\n${output}`);
}

/** Lengths of frames [ms] while `act` goes on. */
async function frames(page, act) {
  await page.evaluate(() => {
    window.frameTimes = [];
    let before = performance.now();
    const next = (now) => {
      window.frameTimes.push(now - before);
      before = now;
      window.frameTimer = requestAnimationFrame(next);
    };
    window.frameTimer = requestAnimationFrame(next);
  });
  await act();
  const times = await page.evaluate(() => {
    cancelAnimationFrame(window.frameTimer);
    return window.frameTimes;
  });
  const sorted = times.slice(2).sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
  const sum = sorted.reduce((total, time) => total + time, 0);
  return { "mean fps": (1000 * sorted.length) / sum, "median ms": at(0.5), "95 % ms": at(0.95) };
}

/** The same canvas while three robots run what is drawn. */
async function running(page, centre, look) {
  await page.locator("[data-tour=run]").click();
  await page.getByText("Running", { exact: true }).waitFor();
  await page.waitForTimeout(2000);
  const moved = async () => {
    for (let i = 0; i < 120; ++i) {
      await page.mouse.wheel(i % 30 < 15 ? 24 : -24, i % 30 < 15 ? 10 : -10);
      await page.waitForTimeout(12);
    }
  };
  const acts = {};
  for (const distance of ["far", "near"]) {
    await look(distance);
    await page.mouse.move(centre.x - 300, centre.y);
    acts[`${distance}, live, still`] = await frames(page, () => page.waitForTimeout(3000));
    acts[`${distance}, live, moved`] = await frames(page, moved);
    acts[`${distance}, from simulator`] = { "kB/s": await kilobytes(page) };
  }
  await page.locator("body").press("Home");
  await page.waitForTimeout(1000);
  acts["from simulator, other page"] = { "kB/s": await kilobytes(page) };
  return acts;
}

/** The canvas moved, zoomed, a node dragged. */
async function standing(page, centre, distance) {
  await page.mouse.move(centre.x, centre.y);
  const moved = await frames(page, async () => {
    for (let i = 0; i < 90; ++i) {
      await page.mouse.wheel(i % 30 < 15 ? 24 : -24, i % 30 < 15 ? 10 : -10);
      await page.waitForTimeout(12);
    }
  });
  await page.keyboard.down("Control");
  const zoomed = await frames(page, async () => {
    for (let i = 0; i < 60; ++i) {
      await page.mouse.wheel(0, i % 20 < 10 ? -30 : 30);
      await page.waitForTimeout(12);
    }
  });
  await page.keyboard.up("Control");
  const at = await grip(page);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  const dragged = await frames(page, async () => {
    for (let i = 0; i < 90; ++i) {
      await page.mouse.move(at.x + 80 * Math.sin(i / 12), at.y + 60 * Math.sin(i / 9));
      await page.waitForTimeout(12);
    }
  });
  await page.mouse.up();
  return { [`${distance}, moved`]: moved, [`${distance}, zoomed`]: zoomed, [`${distance}, dragged`]: dragged };
}

/** Where a node of those in sight is taken hold of. */
function grip(page) {
  return page.evaluate(() => {
    const canvas = document.querySelector(".canvas").getBoundingClientRect();
    const middle = { x: canvas.x + canvas.width / 2, y: canvas.y + canvas.height / 2 };
    const grips = [...document.querySelectorAll(".react-flow__node-node")].map((node) => {
      const { x, y, width, height } = node.getBoundingClientRect();
      return { x: x + width / 2, y: y + Math.min(6, height / 2) };
    });
    const away = ({ x, y }) => Math.hypot(x - middle.x, y - middle.y);
    return grips.sort((a, b) => away(a) - away(b))[0];
  });
}

/** The camera from which the whole page is seen, or nodes at their actual size; fails where a wire is missing there. */
async function looking(page, drawn, distance) {
  await page.locator("body").press("f");
  await page.waitForTimeout(1000);
  if (distance === "near") {
    await page.locator("body").press("1");
    await page.waitForTimeout(1000);
    const at = await grip(page); // there is one in the middle
    const canvas = await page.locator(".canvas").boundingBox();
    await page.mouse.move(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
    await page.mouse.wheel(at.x - canvas.x - canvas.width / 2, at.y - canvas.y - canvas.height / 2);
    await page.waitForTimeout(1000);
  }
  const seen = await wiresInSight(page);
  const isWhole = distance === "near" ? seen.wires > 0 : seen.wires === drawn - 1 && seen.nodes === drawn;
  if (!isWhole || seen.loose > 0 || seen.bare > 0)
    throw new Error(`of ${drawn} nodes, ${distance}, these are in sight: ${JSON.stringify(seen)}`);
  return seen;
}

/** What the simulator sends in a second. */
async function kilobytes(page) {
  const before = page.receivedBytes;
  await page.waitForTimeout(3000);
  return (page.receivedBytes - before) / 3000;
}

async function measure(nodes) {
  const folder = mkdtempSync(join(tmpdir(), "mlab-bench-"));
  const file = join(folder, "many.cdl");
  writeFileSync(file, configuration(nodes));
  const { mlab, url } = await start(folder, file);
  const browser = await openBrowser();
  try {
    const page = await browser.page(size);
    page.setDefaultTimeout(120_000);
    page.receivedBytes = 0;
    page.on("websocket", (socket) => {
      if (socket.url().includes("/session"))
        socket.on("framereceived", ({ payload }) => (page.receivedBytes += payload.length));
    });
    const begin = performance.now();
    await page.goto(url);
    await page.locator("[aria-busy=false] .react-flow__node").first().waitFor();
    const load = performance.now() - begin;
    await page.waitForTimeout(3000);
    const drawn = 1 + Number.parseInt(await page.getByTestId("selected").textContent(), 10); // and the result
    const box = await page.locator(".canvas").boundingBox();
    const centre = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    const acts = {};
    const seen = {};
    for (const distance of ["far", "near"]) {
      seen[distance] = await looking(page, drawn, distance);
      Object.assign(acts, await standing(page, centre, distance));
    }
    Object.assign(acts, await running(page, centre, (distance) => looking(page, drawn, distance)));
    return { drawn, load, seen, acts };
  } finally {
    await browser.close();
    mlab.kill("SIGINT");
    await new Promise((resolve) => mlab.on("exit", resolve));
    rmSync(folder, { recursive: true, force: true });
  }
}

for (const nodes of counts.length > 0 ? counts : [10, 500, 2000]) {
  const { drawn, load, seen, acts } = await measure(nodes);
  const inSight = Object.entries(seen).map(([distance, { nodes, wires }]) => `${distance} ${nodes} and ${wires} wires`);
  console.log(
    `${nodes} nodes: ${drawn} drawn, in sight ${inSight.join(", ")}; first drawing after ${Math.round(load)} ms`,
  );
  for (const [act, figures] of Object.entries(acts)) {
    const shownFigures = Object.entries(figures).map(([name, value]) => `${name} ${value.toFixed(1)}`);
    console.log(`  ${act.padEnd(26)} ${shownFigures.join("   ")}`);
  }
}
