// While a robot's own program takes its time the console answers everything.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import type { Console } from "./console.ts";

/** Drives ahead, and from its 20th cycle on takes 9 s for each. */
const kSlow = `init
#include <chrono>
#include <thread>
iend
procedure Vector Dawdle with
header
  int cycles = 0;
body
  output = {1, 0, 0};
  if (++cycles > 20) std::this_thread::sleep_for(std::chrono::seconds(9));
pend
node ahead is Dawdle with nend
node wheels is Drive with v = ahead; nend
`;

const kMission = `MISSION NAME "slow"
MISSION-AREA 1000 1000
NEW-ROBOT slow "slow.cnl"
UNIT <a> slow
COMMAND LIST:
  0. UNIT a START 100 100
  1. UNIT a MOVETO 900 100
`;

test("while a robot's own program is awaited the console beats, saves, stops and aborts", async () => {
  const { console, project } = await begin({
    mission: "demo_c",
    prepare: (folder) => {
      folder.write("demo_c.mdl", kMission);
      folder.write("slow.cnl", kSlow);
    },
    options: ["--speed", "1"],
  });
  const { page } = console;
  await console.reaches("Ready");
  const panel = await console.panel("Text");
  const text = panel.getByRole("textbox", { name: /^Text of / });
  await text.click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText("  2. UNIT a MOVETO 100 900\n");
  await console.button("Not saved").waitFor();
  await console.main.click();
  await console.reaches("Running");
  await console.passes(1.5);

  await isAwaited(console);
  const began = Date.now();
  const time = await console.time();
  await panel.getByRole("button", { name: "Save", exact: true }).click();
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("demo_c.mdl")).toContain("2. UNIT a MOVETO 100 900");
  expect(await page.getByTestId("silence").count()).toBe(0);
  await console.reaches("Running");
  await console.stop.click();
  await console.reaches("Emergency stop", 2000);
  await console.stop.getByText("0 of 1 stand").waitFor({ timeout: 2000 });
  expect(await console.time()).toBe(time);
  // So far nothing has waited for the robot.
  expect(Date.now() - began).toBeLessThan(7000);
  await console.stop.getByText("confirmed: it stands").waitFor();

  await console.button("Release the stop").first().click();
  await console.reaches("Paused");
  await console.main.filter({ hasText: "Resume" }).click();
  await console.reaches("Running");
  await isAwaited(console);
  await console.panel("Mission");
  const asked = Date.now();
  await console.button("Abort").click();
  await page.getByRole("dialog", { name: "Abort the mission?" }).getByRole("button", { name: "Abort" }).click();
  await console.reaches("Aborted", 5000);
  expect(Date.now() - asked).toBeLessThan(6000);
});

/** Waits for a cycle that takes long: time stands still. */
async function isAwaited(console: Console): Promise<void> {
  let before = Number.NaN;
  const stands = async () => {
    const now = await console.time();
    const isSame = now === before;
    before = now;
    return isSame;
  };
  await expect.poll(stands, { interval: 700, timeout: 20_000 }).toBe(true);
}
