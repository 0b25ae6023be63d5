// What must never be looked for is on the screen, however small that is.
import { expect, test } from "vitest";
import { begin, look } from "./begin.ts";
import { expectWithin } from "./within.ts";

/** CSS pixels: telephones, and a window of 1280 x 800 at 100, 200 and 400 %. */
const kSizes = [
  [1280, 800],
  [1000, 700],
  [768, 1024],
  [640, 400],
  [390, 844],
  [320, 568],
  [320, 200],
] as const;

test("the emergency stop, the state of the run and questions lie within every window", async () => {
  const { console, mlab } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  await console.setSpeed("Max");
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    for (const what of [console.stop, console.state, console.main]) await expectWithin(what);
    await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }
  await console.main.click();
  const question = console.questions.locator("[data-question]").first();
  await question.waitFor();
  await console.reaches("Waits for you");
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    await expectWithin(question.getByRole("button", { name: /^PROCEED/ }));
    await expectWithin(question.getByRole("button", { name: /^ABORT/ }));
    for (const what of [console.stop, console.state, console.main]) await expectWithin(what);
  }
  // Who only watches reads the whole of his button, too.
  const watching = await look(mlab, { width: 320, height: 568 });
  await watching.main.filter({ hasText: "Ask for control" }).waitFor();
  expect(await watching.main.evaluate((button) => button.scrollWidth - button.clientWidth)).toBe(0);
  await console.stop.click();
  await console.stop.getByText("confirmed: all 4 stand").waitFor();
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    for (const what of [console.stop, console.state, console.main]) await expectWithin(what);
  }
});

test("on a telephone a panel lies over the map, and goes again", async () => {
  const { console, mlab } = await begin({ mission: "demo_c", size: { width: 390, height: 844 } });
  await console.reaches("Ready");
  await expectWithin(console.map.locator("xpath=.."));
  for (const title of ["Robots", "Selection"]) {
    const panel = await console.panel(title);
    await expectWithin(panel.getByRole("button", { name: `Close ${title}` }));
    for (const what of [console.stop, console.state]) await expectWithin(what);
    await panel.getByRole("button", { name: `Close ${title}` }).click();
    await panel.waitFor({ state: "detached" });
  }
  // Who watches is told so, and reads the head of a panel nevertheless.
  const watching = await look(mlab, { width: 390, height: 844 });
  const told = watching.page.getByText("You are watching.");
  await told.waitFor();
  const panel = await watching.panel("Robots");
  await told.waitFor({ state: "hidden" });
  await panel.getByRole("button", { name: "Close Robots" }).click();
  await told.waitFor();
});

test("tabs, orders of robots and the command line have room in the smallest windows", async () => {
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "1"] });
  const { page } = console;
  await console.reaches("Ready");
  await console.main.click();
  await console.reaches("Running");
  await console.select("Robot 2");
  const robots = await console.panel("Robots");
  const order = console.rowOf(robots, "Robot 2").locator(".robot-follows");
  await expect.poll(() => order.evaluate((one) => one.clientWidth)).toBeGreaterThan(50);
  for (const [width, height] of kSizes.slice(0, -1)) {
    await page.setViewportSize({ width, height });
    const selection = await console.panel("Selection");
    const title = selection.getByRole("heading", { name: "Robot 2" });
    expect(await title.evaluate((one) => one.scrollWidth - one.clientWidth)).toBe(0);
    await expectWithin(selection.getByRole("button", { name: "scouts-1" }));
    for (const tab of await selection.getByRole("tab").all()) await expectWithin(tab);
    expect((await console.commandLine.boundingBox())?.width).toBeGreaterThan(140);
  }
  // The tools leave the scale to be seen, however low the map is.
  await page.setViewportSize({ width: 640, height: 400 });
  await page.getByRole("button", { name: "Close Selection" }).click();
  const tools = await page.locator(".map-tools").boundingBox();
  const map = await page.locator(".centre").boundingBox();
  expect((map?.y ?? 0) + (map?.height ?? 0) - (tools?.y ?? 0) - (tools?.height ?? 0)).toBeGreaterThan(54);
  // Kinds are read whole.
  await page.setViewportSize({ width: 1280, height: 800 });
  const kinds = (await console.panel("Draw")).locator(".overlay-kind span");
  const cut = await kinds.evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth + 1).length);
  expect(await kinds.count()).toBeGreaterThan(10);
  expect(cut).toBe(0);
});
