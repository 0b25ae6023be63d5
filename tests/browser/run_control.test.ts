// What starts, pauses and stops the run is in reach whatever else is shown.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("the large button starts the mission and is gone then; the top bar's stays, whatever panel is open", async () => {
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "0.5"] });
  const { page } = console;
  await console.reaches("Ready");
  await console.main.getByText("Execute").waitFor();
  await console.start.filter({ hasText: "Execute" }).click();
  await console.reaches("Running");
  await console.start.waitFor({ state: "detached" });
  for (const panel of ["Robots", "Draw", "World"]) {
    await console.panel(panel);
    await console.main.filter({ hasText: "Pause" }).click();
    await console.reaches("Paused");
    await console.main.filter({ hasText: "Resume" }).click();
    await console.reaches("Running");
  }
  await console.main.focus();
  await page.keyboard.press("Enter");
  await console.reaches("Paused");
  const before = await console.time();
  await page.getByRole("button", { name: /^Step: / }).click();
  await expect.poll(() => console.time()).toBeGreaterThan(before);
});

test("the emergency stop is whole in every state of the run, in a small window", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  const whole = async () => {
    const box = await console.stop.boundingBox();
    if (!box) throw new Error("the emergency stop is not shown");
    expect(box.x + box.width).toBeLessThanOrEqual(1280);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(1280);
  };
  await console.reaches("Ready");
  await whole();
  await console.panel("World");
  await console.button("Add obstacle").click();
  await console.dragMap([500, 140], [520, 140]);
  await console.button("Not saved").waitFor();
  await console.setSpeed("Max");
  await console.main.click();
  await console.reaches("Waits for you");
  await whole();
  await page.keyboard.press("Control+.");
  await console.reaches("Emergency stop");
  await whole();
});

test("abort and restart ask once; after an abort no jump is offered", async () => {
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "2"] });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.steps.getByText(/^1 of /).waitFor();
  await console.button("Abort").click();
  const dialog = page.getByRole("dialog", { name: "Abort the mission?" });
  await dialog.getByRole("button", { name: "Go on as it is" }).click();
  await dialog.waitFor({ state: "detached" });
  await console.reaches("Running");
  await console.button("Abort").click();
  await dialog.getByRole("button", { name: "Abort", exact: true }).click();
  await console.reaches("Aborted");
  await console.steps.getByText(/^1 of /).waitFor(); // the one that was aborted is not done

  // Its robots are stopped for good: no step but the first would move one.
  await console.button("Actions of step 1").click();
  const jump = page.getByRole("menuitem", { name: /^Jump to this step/ });
  await jump.waitFor();
  expect(await jump.getAttribute("aria-disabled")).toBe("true");
  await page.keyboard.press("Escape");
  // It has ended: nothing is given up.
  await page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name: "Restart", exact: true }).click();
  await console.reaches("Ready");
  await expect.poll(() => console.time()).toBe(0); // shown some times a second
  await console.main.filter({ hasText: "Execute" }).click();
  await console.reaches("Running");
  await console.button("Restart").click();
  await page
    .getByRole("dialog", { name: "Restart the run?" })
    .getByRole("button", { name: "Restart", exact: true })
    .click();
  await console.reaches("Ready");
  await expect.poll(() => console.time()).toBe(0); // shown some times a second
});
