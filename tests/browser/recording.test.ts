// A run that was recorded, as a page: any moment of it, and nothing that goes on.
import { spawnSync } from "node:child_process";
import { expect, onTestFinished, test } from "vitest";
import { look, Project } from "./begin.ts";
import { Mlab } from "./mlab.ts";

/** The run of a mission that comes with mlab, recorded. */
function recorded(mission: string): string {
  const project = new Project(mission);
  onTestFinished(() => project.remove());
  const file = project.path("yesterday.mcap");
  const options = ["run", project.path(`${mission}.mdl`), "--headless", "--proceed", "--record", file];
  const { status, stderr } = spawnSync(process.env.MLAB_COMMAND ?? "mlab", options, { encoding: "utf8" });
  if (status !== 0) throw new Error(`mlab ended with ${status}:\n${stderr}`);
  return file;
}

test("a recording is gone through from its beginning to its end, and is told nothing", async () => {
  const mlab = await Mlab.replay(recorded("demo_c"));
  onTestFinished(async () => {
    await mlab.stop();
  });
  const console = await look(mlab);
  const { page } = console;
  await page.getByRole("heading", { name: "Recording ‘yesterday’" }).waitFor();
  await expect.poll(() => page.title()).toMatch(/^Recording ‘yesterday’/);
  const line = page.getByRole("region", { name: "Time line" });
  const slider = line.getByRole("slider", { name: "Moment of the run" });
  await slider.focus();
  await page.keyboard.press("End");
  await console.reaches("Done");
  await expect.poll(() => console.time()).toBeGreaterThan(100);

  // No now, no orders, texts to be read.
  expect(await line.getByRole("button", { name: "Now", exact: true }).count()).toBe(0);
  expect(await console.stop.count()).toBe(0);
  expect(await console.main.count()).toBe(0);
  await page.getByPlaceholder("This is a recording: nothing goes on in it.").waitFor();
  const text = await console.panel("Text");
  expect(await text.getByRole("button", { name: "Save as…" }).isDisabled()).toBe(true);
  await expect.poll(() => text.locator(".cm-content").textContent()).toMatch(/MISSION|SCENARIO|UNIT/i);

  // Playing at the end begins anew.
  await line.getByRole("button", { name: "Play what was" }).click();
  await expect.poll(() => console.time()).toBeLessThan(20);
  await line.getByRole("button", { name: "Let time stand" }).click();

  // What happened leads to its moment.
  const log = await console.panel("Log");
  const entry = log.getByRole("button", { name: /look at this moment$/ }).first();
  await entry.waitFor();
  await entry.click();
  await console.select("Robot 1");
  await page.keyboard.press("Home");
  expect(await console.button(/^EMERGENCY/).count()).toBe(0);
});
