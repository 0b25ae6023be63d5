import fc from "fast-check";
import { expect, test } from "vitest";
import { curveBetween, loopAt, onRim } from "./curve.ts";

const box = (x: number, y: number) => ({ x, y, width: 100, height: 60 });

test("a transition that nothing is in the way of goes straight, from rim to rim", () => {
  const curve = curveBetween(box(0, 0), box(300, 0), 0, false);
  expect(curve.begin).toEqual({ x: 100, y: 30 });
  expect(curve.end).toEqual({ x: 300, y: 30 });
  expect(curve.pointAt(0.5)).toEqual({ x: 200, y: 30 });
  expect(curve.pointAt(0)).toEqual(curve.begin);
  expect(curve.pointAt(1)).toEqual(curve.end);
});

test("the rim is left on its border", () => {
  fc.assert(
    fc.property(fc.integer({ min: -500, max: 500 }), fc.integer({ min: -500, max: 500 }), (x, y) => {
      const at = onRim(box(0, 0), { x, y });
      const isOnSide = Math.abs(at.x) < 1e-6 || Math.abs(at.x - 100) < 1e-6;
      const isOnTop = Math.abs(at.y) < 1e-6 || Math.abs(at.y - 60) < 1e-6;
      expect(isOnSide || isOnTop).toBe(true);
    }),
  );
});

test("loops of a state stand above each other, or below it", () => {
  const top = (place: number) => loopAt(box(0, 0), place).pointAt(0.5).y;
  expect(top(1)).toBeLessThan(top(0));
  expect(top(0)).toBeLessThan(0);
  expect(top(-1)).toBeGreaterThan(60);
  expect(top(-2)).toBeGreaterThan(top(-1));
});
