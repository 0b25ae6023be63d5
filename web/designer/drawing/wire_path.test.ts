import { expect, test } from "vitest";
import { badgePlace } from "./wire_path.ts";

test("a value stands in the middle of its wire where there is room", () => {
  const { at, isAbove } = badgePlace({ x: 100, y: 20 }, { x: 300, y: 60 });
  expect(isAbove).toBe(false);
  expect(at).toEqual({ x: 200, y: 40 });
});

test("on a short wire, or one that goes back, it stands above the node that it comes from", () => {
  for (const x of [140, 100, -200]) {
    const { at, isAbove } = badgePlace({ x: 100, y: 20 }, { x, y: 60 });
    expect(isAbove).toBe(true);
    expect(at.y).toBeLessThan(0);
  }
});
