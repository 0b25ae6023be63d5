import fc from "fast-check";
import { expect, test } from "vitest";
import { gridSpots } from "./grid.ts";
import { placeNew } from "./place_new.ts";

const place = fc.record({ x: fc.integer({ min: -400, max: 400 }), y: fc.integer({ min: -400, max: 400 }) });

test("what stands stays, and nothing new lies on anything", () => {
  fc.assert(
    fc.property(fc.array(place, { maxLength: 12 }), fc.array(place, { maxLength: 12 }), (standing, coming) => {
      const sizes = [...standing, ...coming].map((_, i) => ({ id: `n${i}`, width: 120, height: 60 }));
      const own = new Map(standing.map((at, i) => [`n${i}`, at]));
      const laidOut = [...standing, ...coming].map((at, i) => ({ id: `n${i}`, ...at }));
      const places = placeNew(own, laidOut, sizes);
      expect(places.size).toBe(sizes.length);
      for (const [id, at] of own) expect(places.get(id)).toEqual(at);
      const all = [...places];
      for (let i = standing.length; i < all.length; ++i) {
        for (let j = 0; j < i; ++j) {
          const [a, b] = [all[i]![1], all[j]![1]];
          expect(Math.abs(a.x - b.x) >= 120 || Math.abs(a.y - b.y) >= 60).toBe(true);
        }
      }
    }),
  );
});

test("things without wires stand in rows", () => {
  const nodes = Array.from({ length: 5 }, (_, i) => ({ id: `${i}`, width: 160, height: 40, inputs: [], outputY: -1 }));
  const spots = gridSpots({ kind: "grid", nodes, wires: [] });
  expect(spots.map(({ x, y }) => [x, y])).toEqual([
    [0, 0],
    [200, 0],
    [400, 0],
    [600, 0],
    [0, 80],
  ]);
});
