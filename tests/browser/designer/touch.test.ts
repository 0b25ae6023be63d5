// Fingers: what a swipe does in the palette, and that components are dragged out of it.
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";

/** One finger from here to there [px of the window]. */
async function swipe({ page }: DesignerPage, from: [number, number], to: [number, number]): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const at = (share: number) => ({
    x: from[0] + (to[0] - from[0]) * share,
    y: from[1] + (to[1] - from[1]) * share,
  });
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [at(0)] });
  for (let i = 1; i <= 10; ++i)
    await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [at(i / 10)] });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}

test("a finger scrolls the palette, and drags components out of it", async () => {
  const { designer } = await begin();
  const { page, palette } = designer;
  await designer.newAssemblage("Wander");
  const panel = palette.locator(".panel");
  const entry = palette.getByRole("listitem").getByRole("button").nth(1);
  const title = (await entry.locator(".palette-title").textContent()) ?? "";
  const { x, y, width, height } = (await entry.boundingBox())!;
  const middle: [number, number] = [x + width / 2, y + height / 2];
  await swipe(designer, middle, [middle[0] + 4, 700]);
  expect(await panel.evaluate((one) => one.scrollTop)).toBe(0); // it is at its top
  await swipe(designer, [middle[0], 600], [middle[0] + 6, 300]);
  await expect.poll(() => panel.evaluate((one) => one.scrollTop)).toBeGreaterThan(100);
  expect(await page.locator(".react-flow__node-node").count()).toBe(0);
  expect(await page.evaluate(() => window.scrollX + window.scrollY)).toBe(0);
  // It may still be gliding.
  const back = (one: Element): Promise<number> => {
    one.scrollTo(0, 0);
    return new Promise((resolve) => setTimeout(() => resolve(one.scrollTop), 200));
  };
  await expect.poll(() => panel.evaluate(back)).toBe(0);
  await swipe(designer, middle, [middle[0] + 400, middle[1] + 120]);
  await expect.poll(() => page.locator(".react-flow__node-node").count()).toBe(1);
  await page.locator(".react-flow__node-node", { hasText: title.split(" ")[0]! }).waitFor();
  expect(await page.locator(".palette-ghost").count()).toBe(0);
  // Sideways within the palette nothing happens, and the browser leads nowhere.
  await swipe(designer, [middle[0] - 60, middle[1]], [middle[0] + 40, middle[1]]);
  expect(await page.locator(".react-flow__node-node").count()).toBe(1);
  await designer.on("Wander");
});
