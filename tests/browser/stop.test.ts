import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("the key of the emergency stop stops the robots from anywhere, also while typing", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.panel("Robots");
  await expect.poll(async () => (await console.place("Robot 1")).x).toBeGreaterThan(0);

  await console.commandLine.fill("UNIT scouts MOV");
  await page.keyboard.press("Control+.");
  await console.reaches("Emergency stop");
  await page.getByText("EMERGENCY STOP: all robots stand and take no orders.").waitFor();
  // The list may still show where it was a moment ago.
  await expect
    .poll(async () => {
      const before = await console.place("Robot 1");
      await page.waitForTimeout(400);
      return (await console.place("Robot 1")).y - before.y;
    })
    .toBe(0);
  const place = await console.place("Robot 1");
  const time = await console.time();

  // No order moves them.
  await page.keyboard.press("Escape");
  await console.commandLine.fill("UNIT scouts MOVETO 400 400");
  await console.commandLine.press("Enter");
  await console.panel("Mission");
  expect(await console.button("Step").isDisabled()).toBe(true);
  await console.panel("Robots");
  expect(await console.place("Robot 1")).toEqual(place);
  expect(await console.time()).toBe(time);

  await console.button("Release the stop").first().click();
  await console.reaches("Paused");
});

test("the emergency stop works over every dialog, by mouse and by key", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await page.keyboard.press("Control+k");
  await page.getByRole("dialog", { name: "Search everything" }).waitFor();
  await page.keyboard.press("Control+.");
  await console.reaches("Emergency stop");
  await page.keyboard.press("Escape");
  await console.button("Release the stop").first().click();
  await console.reaches("Paused");
  await console.main.click();
  await console.reaches("Running");
  await page.keyboard.press("Control+o");
  await page.getByRole("dialog", { name: "Open a mission" }).waitFor();
  const box = await console.stop.boundingBox();
  if (!box) throw new Error("the emergency stop is not shown");
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await console.reaches("Emergency stop");
});

test("the emergency stop lies over the sheet of shortcuts", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await page.keyboard.press("?");
  await page.getByRole("heading", { name: "Keyboard shortcuts" }).waitFor();
  const box = await console.stop.boundingBox();
  if (!box) throw new Error("the emergency stop is not shown");
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await console.reaches("Emergency stop");
});
