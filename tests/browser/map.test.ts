// What the map tells of places and distances.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("the coordinates under the pointer are told, and hidden when it leaves the map", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const readout = page.locator(".map-place");
  for (const [x, y] of [
    [500, 140],
    [930, 640],
  ] as const) {
    const at = await console.onPage(x, y);
    await page.mouse.move(at.x, at.y);
    const text = (await readout.textContent()) ?? "";
    const [east = Number.NaN, north = Number.NaN] = text.split(",").map(Number.parseFloat);
    expect(Math.abs(east - x)).toBeLessThan(2);
    expect(Math.abs(north - y)).toBeLessThan(2);
  }
  await page.mouse.move(20, 400);
  await expect.poll(() => readout.isVisible()).toBe(false);
});

test("distances and bearings are measured by mouse and by keys", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  await page.getByRole("toolbar", { name: "Map tools" }).getByRole("button", { name: "Measure" }).click();
  const words = page.getByRole("region", { name: "Measure" }).getByRole("status");
  await words.getByText("Click, or").waitFor();
  const click = async (x: number, y: number, clicks = 1) => {
    const at = await console.onPage(x, y);
    await page.mouse.move(at.x, at.y);
    await page.waitForTimeout(500); // else two clicks would be a double click
    await page.mouse.click(at.x, at.y, { clickCount: clicks });
  };
  await click(400, 300);
  await click(600, 300);
  expect(Number.parseFloat((await words.textContent()) ?? "")).toBeCloseTo(200, -1);
  expect(await words.textContent()).toContain("bearing 090°");
  const at = await console.onPage(600, 500);
  await page.waitForTimeout(500);
  await page.mouse.dblclick(at.x, at.y);
  await words.getByText(/whole/).waitFor();
  expect(await words.textContent()).toContain("bearing 000°");
  expect(Number.parseFloat(((await words.textContent()) ?? "").split("whole")[1] ?? "")).toBeCloseTo(400, -1);

  // The next line, by keys alone: from the middle of the map to one that lies east of it.
  await console.map.focus();
  await page.keyboard.press("Escape");
  await words.getByText("Click, or").waitFor();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await console.camera();
  await page.keyboard.press("Enter");
  await words.getByText("bearing 090°").waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await words.waitFor({ state: "detached" });
});
