import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("panels come and go by their keys without a trace in the undo history", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  await console.steps.waitFor();
  await console.page.keyboard.press("1");
  await console.steps.waitFor({ state: "detached" });
  expect(await console.button("Nothing to undo").isEnabled()).toBe(false);
  await console.page.keyboard.press("1");
  await console.steps.waitFor();
});

test("at 1280 x 800 the map keeps half of the window, whatever is opened and told", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const share = async () => {
    const box = await page.locator(".centre").boundingBox();
    return box ? (box.width * box.height) / (1280 * 800) : 0;
  };
  expect(await share()).toBeGreaterThanOrEqual(0.5);
  for (const key of ["5", "8", "7", "0", "2"]) {
    await page.keyboard.press(key);
    expect(await share()).toBeGreaterThanOrEqual(0.5);
  }
});

test("a banner that comes or goes moves nothing", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  const places = () =>
    page.evaluate(() =>
      [...document.querySelectorAll(".centre, .dock, .rail, .strip, .transport-button, .map-tools")].map((element) => {
        const { x, y, width, height } = element.getBoundingClientRect();
        return [x, y, width, height].map(Math.round);
      }),
    );
  await page.getByRole("region", { name: "Time line" }).waitFor();
  const before = await places();
  await console.stop.click();
  await page.getByText("EMERGENCY STOP: all robots stand and take no orders.").waitFor();
  expect(await places()).toEqual(before);
});

test("letters are shortcuts also while a list has the focus", async () => {
  const { console } = await begin({ mission: "demo_c", options: ["--speed", "0.5"] });
  await console.main.click();
  await console.reaches("Running");
  await console.select("Robot 1");
  const isInList = () => document.activeElement?.closest("[role=grid], [role=treegrid]") !== null;
  await expect.poll(() => console.page.evaluate(isInList)).toBe(true);
  await console.page.keyboard.press("x");
  await console.reaches("Paused");
  await console.page.keyboard.press("x");
  await console.reaches("Running");
});
