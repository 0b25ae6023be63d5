// Other moments of a run, on the drawing: its states and values are those of then.
import { spawnSync } from "node:child_process";
import { expect, test } from "vitest";
import { begin } from "./designer.ts";
import { opened, run, time, turns } from "./running.ts";

test("the drawing shows states, values and the robot's history of any moment, and returns to now", async () => {
  const { designer } = await opened(turns(2));
  const { page, simulator } = designer;
  await designer.on("Turns");
  await run(designer);
  await expect.poll(() => time(designer)).toBeGreaterThan(7);
  const line = page.getByRole("region", { name: "Time line" });
  const field = line.getByRole("textbox", { name: "Time that is shown" });
  const told = page.getByRole("status").filter({ hasText: "You are looking at" });
  const active = page.locator(".state.active");
  const goTo = async (text: string) => {
    await field.fill(text);
    await field.press("Enter");
    await expect.poll(() => time(designer)).toBeCloseTo(Number(text), 1);
  };
  await goTo("1");
  await told.waitFor();
  await simulator.getByText("Not now", { exact: true }).waitFor();
  await active.filter({ hasText: "Waiting" }).waitFor();
  await goTo("3");
  await active.filter({ hasText: "Moving" }).waitFor();
  expect(await active.filter({ hasText: "Waiting" }).count()).toBe(0);
  await goTo("5");
  await active.filter({ hasText: "Waiting" }).waitFor();

  // What was when nobody looked: each state with its begin.
  const states = simulator.getByRole("region", { name: "States over the run" });
  await states.getByRole("button", { name: "As a table" }).click();
  const moving = states.getByRole("row").filter({ hasText: "Moving" }).first();
  await moving.getByRole("button", { name: /go there$/ }).click();
  await active.filter({ hasText: "Moving" }).waitFor();
  expect(await time(designer)).toBeLessThan(3);

  // Nothing is ordered there.
  expect(await designer.button("One cycle").isDisabled()).toBe(true);
  await designer.button("Back to now").click();
  await told.waitFor({ state: "detached" });
  await expect.poll(() => time(designer)).toBeGreaterThan(7);
  await designer.button("Pause").waitFor();
});

/** Of the mission's own run, without a page. */
function record(mission: string, file: string): void {
  const options = ["run", mission, "--headless", "--proceed", "--quiet", "--for", "90", "--record", file];
  const { status, stderr } = spawnSync(process.env.MLAB_COMMAND ?? "mlab", options, { encoding: "utf8" });
  if (status !== 0) throw new Error(`mlab ended with ${status}:\n${stderr}`);
}

test("a recording is shown on the drawing of its robots", async () => {
  const { designer } = await begin({
    mission: "forage",
    file: "forager.cdl",
    prepare: (project) => record(project.path("forage.mdl"), project.path("yesterday.mcap")),
    options: (project) => ["--recording", project.path("yesterday.mcap")],
  });
  const { page } = designer;
  await designer.goTo("Forage");
  const field = page.getByRole("region", { name: "Time line" }).getByRole("textbox", { name: "Time that is shown" });
  const active = page.locator(".state.active");
  await field.fill("1");
  await field.press("Enter");
  await active.filter({ hasText: "Acquiring" }).waitFor();
  await field.fill("60");
  await field.press("Enter");
  await active.filter({ hasText: "Delivering" }).waitFor();
  expect(await designer.button("Recording").isDisabled()).toBe(true);
});
