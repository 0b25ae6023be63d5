import { expect, test } from "vitest";
import { begin, look } from "./begin.ts";
import { expectWithin } from "./within.ts";

// So slow that the mission has no question while the test looks at it.
const kSlowly = ["--speed", "0.1"];

test("a reload in mid-mission comes back to the same view, and the run goes on", async () => {
  // With room for panels at both sides and the drawer below.
  const { console } = await begin({ mission: "demo_c", options: kSlowly, size: { width: 1600, height: 1000 } });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  await console.select("Robot 3");
  await console.panel("Log");
  await console.panel("Selection");
  await page.getByRole("tab", { name: "Why?" }).click();
  for (let i = 0; i < 3; ++i) await console.button("Zoom in").click();
  const camera = await console.camera();
  const time = await console.time();

  await page.reload();
  await console.reaches("Running");
  await page.getByRole("heading", { name: "Robot 3" }).waitFor();
  await page.getByRole("region", { name: "Log", exact: true }).waitFor();
  expect(await console.camera()).toEqual(camera);
  expect(await console.time()).toBeGreaterThan(time);
  await console.passes(1);
  // Whoever reloads is still the operator.
  await console.button("Operator: you").waitFor();
  await console.panel("Mission");
  await console.main.getByText("Pause").click();
  await console.reaches("Paused");
});

test("a browser that closes changes nothing in the run", async () => {
  const { console, mlab } = await begin({ mission: "demo_c", options: kSlowly });
  await console.main.click();
  await console.reaches("Running");
  const time = await console.time();
  await console.page.close();
  const other = await look(mlab);
  await other.reaches("Running");
  await expect.poll(() => other.time(), { timeout: 30_000 }).toBeGreaterThan(time);
});

test("of two browsers one is the operator, until the place is handed over", async () => {
  const { console: first, mlab } = await begin({ mission: "demo_c", options: kSlowly });
  await first.reaches("Ready");
  await first.button("Operator: you").waitFor();
  const second = await look(mlab);
  await second.watching.waitFor();

  // It sees what the other does, and can do nothing.
  await first.main.click();
  await second.reaches("Running");
  await expectWithin(second.button(/^Operator: /));
  await expectWithin(second.page.getByRole("button", { name: /^Search everything/ }));
  expect(await second.button("Step").isDisabled()).toBe(true);
  await second.panel("World");
  expect(await second.button("Random obstacles…").isDisabled()).toBe(true);
  await second.commandLine.fill("UNIT scouts STOP");
  await second.commandLine.press("Enter");
  await second.page
    .getByText(/operator/)
    .first()
    .waitFor();
  await first.reaches("Running");

  await second.main.filter({ hasText: "Ask for control" }).click();
  await first.page.getByText(/asks to become the operator/).waitFor();
  await first.button("Decline").click();
  await second.main.filter({ hasText: "Ask for control" }).click();
  await first.button("Hand over").click();
  await second.button(/^Operator: you/).waitFor();
  await first.watching.waitFor();
  await second.panel("Mission");
  await second.main.getByText("Pause").click();
  await first.reaches("Paused");
});

test("everybody may stop the robots, and only the operator lets them go again", async () => {
  const { console: first, mlab } = await begin({ mission: "demo_c", options: kSlowly });
  await first.main.click();
  await first.reaches("Running");
  const second = await look(mlab);
  await second.watching.waitFor();
  await second.stop.click();
  await first.reaches("Emergency stop");
  await second.page.getByText("Only the operator can release it.").waitFor();
  await first.button("Release the stop").first().click();
  await second.reaches("Paused");
});

test("the operator's place is free when its browser has gone", async () => {
  const { console: first, mlab } = await begin({ mission: "demo_c", options: kSlowly });
  await first.reaches("Ready");
  const second = await look(mlab);
  await second.watching.waitFor();
  await first.page.close();
  await second
    .button(/^(Take|Ask for) control$/)
    .first()
    .click();
  await second.button(/^Operator: you/).waitFor();
});
