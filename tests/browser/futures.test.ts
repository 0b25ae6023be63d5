// What if: another future beside the run, of one that goes on, of a recording, and of two recordings.
import { spawnSync } from "node:child_process";
import { expect, onTestFinished, test } from "vitest";
import { begin, look, Project } from "./begin.ts";
import type { Console } from "./console.ts";
import { Mlab } from "./mlab.ts";

const line = ({ page }: Console) => page.getByRole("region", { name: "Time line" });
const panel = ({ page }: Console) => page.getByRole("region", { name: "What if", exact: true });

/** The run of a mission that comes with mlab, recorded. */
function recorded(project: Project, file: string, ...options: string[]): string {
  const path = project.path(file);
  const all = ["run", project.path("demo_c.mdl"), "--headless", "--proceed", "--record", path, ...options];
  const { status, stderr } = spawnSync(process.env.MLAB_COMMAND ?? "mlab", all, { encoding: "utf8" });
  if (status !== 0) throw new Error(`mlab ended with ${status}:\n${stderr}`);
  return path;
}

function projectOf(mission: string): Project {
  const project = new Project(mission);
  onTestFinished(() => project.remove());
  return project;
}

async function goTo(console: Console, text: string, time: number): Promise<void> {
  const field = line(console).getByRole("textbox", { name: "Time that is shown" });
  await field.fill(text);
  await field.press("Enter");
  await expect.poll(() => console.time()).toBeCloseTo(time, 1);
}

test("of a run that goes on: another order is computed beside it, shown as ghosts, and the run stays as it is", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.main.click();
  await console.reaches("Running");
  await console.setSpeed("×10");
  await expect.poll(() => console.time()).toBeGreaterThan(25);
  await goTo(console, "15", 15);
  const before = await console.drawnOnTop();
  await line(console).getByRole("button", { name: "What if…" }).click();
  const asked = panel(console);
  await asked.getByRole("radio", { name: "Order" }).click();
  const order = asked.getByRole("textbox", { name: "Order, as it is typed" });
  await order.fill("UNIT scouts FLYTO ATK-AP1");
  await asked.getByRole("button", { name: "Compute" }).click();
  await asked.getByRole("alert").filter({ hasText: "column 13" }).waitFor();
  await order.fill("UNIT scouts STOP");
  await asked.getByRole("textbox", { name: "For how long" }).fill("0:30");
  await asked.getByRole("button", { name: "Compute" }).click();
  await asked.getByText(/They part at/).waitFor();
  await asked.getByRole("img", { name: /Distance between the same robot in both/ }).waitFor();
  await goTo(console, "22", 22);
  await expect.poll(() => console.drawnOnTop()).toBeGreaterThan(before + 200);
  expect(await asked.getByRole("row", { name: /^Robot 1 / }).textContent()).toMatch(/ m at 0:/);

  // Where they part is a moment to go to.
  await asked.getByRole("status").getByRole("button").click();
  await expect.poll(() => console.time()).toBeLessThan(17);
  await asked.getByRole("button", { name: "Remove" }).click();
  await asked.getByRole("radio", { name: "Order" }).waitFor();
  await expect.poll(() => console.drawnOnTop()).toBeLessThan(before + 200);
  await line(console).getByRole("button", { name: "Now", exact: true }).click();
  await expect.poll(() => console.time()).toBeGreaterThan(24);
});

test("of a recording: another parameter, saved as a recording that can be compared", async () => {
  const project = projectOf("demo_c");
  const file = recorded(project, "yesterday.mcap");
  const mlab = await Mlab.replay(file);
  onTestFinished(async () => {
    await mlab.stop();
  });
  const console = await look(mlab);
  const { page } = console;
  await goTo(console, "20", 20);
  await line(console).getByRole("button", { name: "What if…" }).click();
  const asked = panel(console);
  await asked.getByRole("combobox", { name: "Parameter" }).selectOption("base_velocity");
  const value = asked.getByRole("textbox", { name: /^Value/ });
  await expect.poll(() => value.inputValue()).not.toBe("");
  await value.fill("0.3");
  await asked.getByRole("textbox", { name: "For how long" }).fill("20");
  await asked.getByRole("button", { name: "Compute" }).click();
  await asked.getByText(/They part at/).waitFor();
  const download = page.waitForEvent("download");
  await asked.getByRole("button", { name: "Save as recording" }).click();
  const saved = project.path("other.mcap");
  await (await download).saveAs(saved);
  const { status, stdout } = spawnSync(process.env.MLAB_COMMAND ?? "mlab", ["replay", saved, "--headless", "--quiet"], {
    encoding: "utf8",
  });
  expect(stdout).toMatch(/as recorded/);
  expect(status).toBe(0);

  await page.keyboard.press("Escape");
  await asked.waitFor({ state: "detached" });
});

test("two recordings beside each other", async () => {
  const project = projectOf("demo_c");
  const a = recorded(project, "a.mcap", "--seed", "3");
  const b = recorded(project, "b.mcap", "--seed", "4");
  const mlab = await Mlab.replay(a, "--against", b);
  onTestFinished(async () => {
    await mlab.stop();
  });
  const console = await look(mlab);
  const beside = console.page.getByRole("region", { name: "Beside another recording" });
  await beside.getByText("Seed: 3 and 4.").waitFor();
  await beside.getByText(/They part at/).waitFor({ timeout: 60_000 });
  await beside.getByRole("row", { name: /^b done/ }).waitFor();
});

test("an order that is refused there, several changes, and a length that is no time", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.main.click();
  await console.reaches("Running");
  await console.setSpeed("×10");
  await expect.poll(() => console.time()).toBeGreaterThan(20);
  await goTo(console, "15", 15);
  await line(console).getByRole("button", { name: "What if…" }).click();
  const asked = panel(console);
  const length = asked.getByRole("textbox", { name: "For how long" });
  await length.fill("2:75");
  await length.press("Enter");
  await asked.getByText("“2:75” is no time: enter 90, 1:30 or 1:02:03, at most two hours.").waitFor();
  await length.fill("0:20");
  await asked.getByRole("radio", { name: "Order" }).click();
  await asked.getByRole("textbox", { name: "Order, as it is typed" }).fill("UNIT scouts START AA-AA1 0 20");
  await asked.getByRole("button", { name: "Change something else, too" }).click();
  const second = asked.getByRole("region", { name: "Change 2" });
  await second.getByRole("radio", { name: "Parameter" }).click();
  await second.getByRole("combobox", { name: "Parameter" }).selectOption("base_velocity");
  const value = second.getByRole("textbox", { name: /^Value/ });
  await value.fill("fast");
  await asked.getByRole("button", { name: "Compute" }).click();
  await asked.getByRole("alert").filter({ hasText: "“fast” is no number: “base_velocity” takes a number" }).waitFor();
  await value.fill("0.3");
  await asked.getByRole("button", { name: "Compute" }).click();
  const warned = asked.getByRole("list", { name: "Went wrong there" });
  await warned.getByText(/run already and can't be started again/).waitFor();
  expect(await warned.textContent()).toMatch(/0:15\.\d/);
  await asked.getByText(/the order “UNIT scouts START AA-AA1 0 20” and base_velocity = 0.3 for Robot 1/).waitFor();
  await asked
    .getByRole("table", { name: "What was told in one of them alone" })
    .getByText(/can't be started again/)
    .waitFor();
});

test("who only watches sees at once that no design can be changed, and why", async () => {
  const { console: first, mlab } = await begin({ mission: "demo_c" });
  await first.main.click();
  await first.reaches("Running");
  const second = await look(mlab);
  await second.watching.waitFor();
  await expect.poll(() => second.time()).toBeGreaterThan(1);
  await line(second).getByRole("button", { name: "What if…" }).click();
  const asked = panel(second);
  expect(await asked.getByRole("radio", { name: "Design" }).isDisabled()).toBe(true);
  await asked.getByText("Only the operator can change a design: take control first.").waitFor();
  expect(await asked.getByRole("radio", { name: "Order" }).isDisabled()).toBe(false);
});

test("the map stays in sight in small windows", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.setSpeed("×10");
  await expect.poll(() => console.time()).toBeGreaterThan(20);
  await goTo(console, "15", 15);
  await line(console).getByRole("button", { name: "What if…" }).click();
  for (const [width, height] of [
    [1280, 720],
    [800, 600],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    const below = await panel(console).boundingBox();
    const map = await console.map.boundingBox();
    expect(below!.y, `${width}`).toBeGreaterThanOrEqual(map!.y + map!.height - 1);
    expect(map!.height, `${width}`).toBeGreaterThan(0.25 * height);
    expect(below!.height, `${width}`).toBeGreaterThan(0.25 * height);
    const compute = panel(console).getByRole("button", { name: "Compute" });
    const { y, height: high } = (await compute.boundingBox())!;
    expect(y + high, `${width}`).toBeLessThanOrEqual(below!.y + below!.height);
  }
});
