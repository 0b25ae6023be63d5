// A console that was killed is gone on with: from the start page of the next one.
import { rename } from "node:fs/promises";
import { join } from "node:path";
import { expect, onTestFinished, test } from "vitest";
import { begin, look } from "./begin.ts";
import { Mlab } from "./mlab.ts";

test("the start page continues a run that a kill has cut off", async () => {
  const { console, mlab, project } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  await console.startRobots();
  await console.page.close();
  const state = await mlab.kill();
  const next = await Mlab.startAgain(state, "--project", project.folder);
  onTestFinished(async () => {
    await next.stop();
  });
  const after = await look(next);
  const runs = after.page.getByRole("region", { name: "Unfinished runs" });
  await runs.getByRole("button", { name: /Continue ‘demo_c’, stopped at/ }).click();
  const log = await after.panel("Log");
  await log.getByText("the run goes on as it stood at").first().waitFor();
  await after.steps.getByText(/^1 of /).waitFor();
  expect(await log.getByText(/: single step$/).count()).toBeGreaterThan(0);
  await runs.waitFor({ state: "detached" });
});

test("the start page says that the mission of a run is gone, also where it is narrow", async () => {
  const { console, mlab, project } = await begin({ mission: "demo_c" });
  await console.startRobots();
  await console.page.close();
  const state = await mlab.kill();
  await rename(join(project.folder, "demo_c.mdl"), join(project.folder, "elsewhere.mdl"));
  const next = await Mlab.startAgain(state, "--project", project.folder);
  onTestFinished(async () => {
    await next.stop();
  });
  const { page } = await look(next);
  await page.setViewportSize({ width: 390, height: 844 });
  const why = page.getByText(/The run can’t go on, because .demo_c\.mdl. is not there\./);
  await why.waitFor();
  const right = () => why.evaluate((one) => one.getBoundingClientRect().right);
  await expect.poll(right).toBeLessThan(390);
  const box = page.locator(".start");
  expect(await box.evaluate((one) => one.scrollWidth - one.clientWidth)).toBe(0);
  const top = async (name: string) => (await page.getByRole("heading", { name, exact: true }).boundingBox())?.y ?? 0;
  expect(await top("Examples")).toBeGreaterThan((await top("In this project")) + 20);
});
