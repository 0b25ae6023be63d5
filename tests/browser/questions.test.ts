import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a question takes a corner of the map, not the focus, and hands the focus on", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.commandLine.fill("UNIT scouts MOV");
  await console.setSpeed("Max");
  await console.commandLine.focus();
  await page.keyboard.press("Escape");
  await console.main.focus();
  await page.keyboard.press("Enter");
  const question = console.questions.locator("[data-question]");
  await question.waitFor();
  expect(await console.main.evaluate((element) => element === document.activeElement)).toBe(true);

  for (const [width, height] of [
    [1280, 800],
    [1920, 1080],
  ] as const) {
    await page.setViewportSize({ width, height });
    const map = await console.map.boundingBox();
    const card = await question.boundingBox();
    if (!map || !card) throw new Error("map or question is not shown");
    expect((card.width * card.height) / (map.width * map.height)).toBeLessThan(0.1);
    expect(map.x + map.width - (card.x + card.width)).toBeLessThan(24);
    expect(card.y - map.y).toBeLessThan(24);
  }

  // The main button goes there, Enter answers, and the keys go on at the map.
  await page.keyboard.press("x");
  const proceed = question.getByRole("button", { name: /^PROCEED/ });
  await expect.poll(() => proceed.evaluate((element) => element === document.activeElement)).toBe(true);
  const id = await question.getAttribute("data-question");
  await page.keyboard.press("Enter");
  await page.locator(`[data-question="${id}"]`).waitFor({ state: "detached" });
  await expect.poll(() => console.map.evaluate((element) => element === document.activeElement)).toBe(true);
});
