import fc from "fast-check";
import { expect, test } from "vitest";
import { curveBetween, lanesOf, loopAt, onRim } from "./curve.ts";

const box = (x: number, y: number) => ({ x, y, width: 100, height: 60 });

test("a transition alone goes straight, from rim to rim", () => {
  const curve = curveBetween(box(0, 0), box(300, 0), 0, 1, false);
  expect(curve.begin).toEqual({ x: 100, y: 30 });
  expect(curve.end).toEqual({ x: 300, y: 30 });
  expect(curve.middle).toEqual({ x: 200, y: 30 });
});

test("there and back are bent to different sides", () => {
  const there = curveBetween(box(0, 0), box(300, 0), 0, 2, false);
  const back = curveBetween(box(300, 0), box(0, 0), 1, 2, true);
  expect(Math.sign(there.middle.y - 30)).toBe(-Math.sign(back.middle.y - 30));
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

test("transitions between the same states have lanes of their own", () => {
  const lanes = lanesOf([
    { from: "A", to: "B" },
    { from: "B", to: "A" },
    { from: "A", to: "C" },
  ]);
  expect(lanes).toEqual([
    { place: 0, count: 2, isBack: false },
    { place: 1, count: 2, isBack: true },
    { place: 0, count: 1, isBack: false },
  ]);
  expect(loopAt(box(0, 0), 1).middle.y).toBeLessThan(loopAt(box(0, 0), 0).middle.y);
});
