// A recording that can't be computed again opens its page all the same, with what was recorded.
import { expect, onTestFinished, test } from "vitest";
import { look, Project } from "./begin.ts";
import { Mlab } from "./mlab.ts";
import { writeOtherVersion } from "./other_version.ts";

test("a recording of another version shows where robots were and what was told, and says what is missing", async () => {
  const project = new Project("");
  onTestFinished(() => project.remove());
  const file = project.path("later.mcap");
  writeOtherVersion(file, [
    {
      path: "far.mdl",
      content:
        'OVERLAY "map.odl"\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT pair START 100 100 0 40\n1. UNIT pair MOVETO PP-Far\n',
    },
    { path: "map.odl", content: "MISSION-AREA 400 300\nCONTROL MEASURES:\nPP Far 300 120\n" },
  ]);
  const mlab = await Mlab.replay(file);
  onTestFinished(async () => {
    await mlab.stop();
  });
  const console = await look(mlab);
  const { page } = console;
  await page.getByRole("heading", { name: "Recording ‘later’" }).waitFor();
  const banner = page.getByRole("status").filter({ hasText: "it is of format 2" });
  await banner.waitFor();
  expect(await banner.textContent()).toContain("Not shown: values of ports, states and Why?");
  const line = page.getByRole("region", { name: "Time line" });
  const slider = line.getByRole("slider", { name: "Moment of the run" });
  await slider.focus();
  await page.keyboard.press("End");
  await expect.poll(() => console.time()).toBe(60);
  await console.panel("Robots");
  const end = await console.place("Robot 1");
  await slider.focus();
  await page.keyboard.press("Home");
  await expect.poll(() => console.time()).toBe(0);
  const begin = await console.place("Robot 1");
  expect(end.x - begin.x).toBeCloseTo(60, 0);

  // Playing, and what was told.
  await line.getByRole("button", { name: "Play what was" }).click();
  await expect.poll(() => console.time()).toBeGreaterThan(1.5);
  await line.getByRole("button", { name: "Let time stand" }).click();
  const log = await console.panel("Log");
  await log.getByText("robot 2 found something").waitFor();

  // Bookmarks can be made here, too.
  await line.getByRole("button", { name: /^Bookmark this moment/ }).click();
  await page.keyboard.type("seen");
  await page.keyboard.press("Enter");
  await page.getByRole("region", { name: "Bookmarks" }).getByText("seen").waitFor();
});
