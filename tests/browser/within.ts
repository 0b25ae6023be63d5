import type { Locator } from "playwright-core";
import { expect } from "vitest";

/** Waits until all of it lies within the window, and nothing covers it: what a person presses there is this. */
export async function expectWithin(what: Locator): Promise<void> {
  const trouble = () =>
    what.evaluate((element) => {
      const box = element.getBoundingClientRect();
      const { innerWidth: width, innerHeight: height } = window;
      const place = [box.left, box.top, box.right, box.bottom].map(Math.round).join(" ");
      if (box.width < 1 || box.height < 1) return `it has no size: ${place}`;
      if (box.left < -0.5 || box.top < -0.5 || box.right > width + 0.5 || box.bottom > height + 0.5)
        return `${place} does not lie within ${width} x ${height}`;
      for (const [x, y] of [
        [0.5, 0.5],
        [0.1, 0.5],
        [0.9, 0.5],
      ] as const) {
        const hit = document.elementFromPoint(box.left + box.width * x, box.top + box.height * y);
        // What holds it is no better: then it is cut off there.
        if (!element.contains(hit)) return `${hit?.className || hit?.tagName} covers it`;
      }
      return "";
    });
  await expect.poll(trouble, { timeout: 30_000 }).toBe("");
}
