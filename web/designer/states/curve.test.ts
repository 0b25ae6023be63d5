import fc from "fast-check";
import { expect, test } from "vitest";
import { bendsOf } from "./bends.ts";
import { curveBetween, loopAt, onRim } from "./curve.ts";

const box = (x: number, y: number) => ({ x, y, width: 100, height: 60 });

test("a transition that nothing is in the way of goes straight, from rim to rim", () => {
  const curve = curveBetween(box(0, 0), box(300, 0), 0, false);
  expect(curve.begin).toEqual({ x: 100, y: 30 });
  expect(curve.end).toEqual({ x: 300, y: 30 });
  expect(curve.middle).toEqual({ x: 200, y: 30 });
});

test("there and back do not lie on each other", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(300, 0)],
  ]);
  const ways = [
    { from: "A", to: "B", labelWidth: 80 },
    { from: "B", to: "A", labelWidth: 80 },
  ];
  const bends = bendsOf(ways, rects);
  const there = curveBetween(rects.get("A")!, rects.get("B")!, bends[0]!, false);
  const back = curveBetween(rects.get("B")!, rects.get("A")!, bends[1]!, true);
  expect(Math.abs(there.middle.y - back.middle.y)).toBeGreaterThan(20);
});

test("a transition goes round a state that stands between", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(300, 0)],
    ["C", box(600, 0)],
  ]);
  const [bend] = bendsOf([{ from: "A", to: "C", labelWidth: 60 }], rects);
  expect(Math.abs(bend!)).toBeGreaterThan(30);
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

test("loops of a state stand above each other", () => {
  expect(loopAt(box(0, 0), 1).middle.y).toBeLessThan(loopAt(box(0, 0), 0).middle.y);
  expect(
    bendsOf(
      [
        { from: "A", to: "A", labelWidth: 9 },
        { from: "A", to: "A", labelWidth: 9 },
      ],
      new Map([["A", box(0, 0)]]),
    ),
  ).toEqual([0, 1]);
});
