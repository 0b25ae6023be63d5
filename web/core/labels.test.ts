import fc from "fast-check";
import { expect, test } from "vitest";
import { overlaps } from "./geometry.ts";
import { clustersOf, type LabelWish, placeLabels, TakenBoxes } from "./labels.ts";

const kScreen = { xMin: 0, yMin: 0, xMax: 400, yMax: 300 };
const wish = (): fc.Arbitrary<LabelWish<number>> =>
  fc.record({
    key: fc.nat(),
    width: fc.integer({ min: 5, max: 90 }),
    height: fc.constant(14),
    weight: fc.integer({ min: 0, max: 5 }),
    places: fc.array(fc.record({ x: fc.integer({ min: -20, max: 420 }), y: fc.integer({ min: -20, max: 320 }) }), {
      maxLength: 5,
    }),
  });

test("no two names overlap, none leaves the screen, none covers what is taken", () => {
  fc.assert(
    fc.property(fc.array(wish(), { maxLength: 40 }), (wishes) => {
      const taken = { xMin: 100, yMin: 100, xMax: 150, yMax: 130 };
      const placed = placeLabels(wishes, new TakenBoxes([taken]), kScreen);
      placed.forEach(({ box }, i) => {
        expect(overlaps(box, taken)).toBe(false);
        expect(box.xMin >= 0 && box.yMin >= 0 && box.xMax <= 400 && box.yMax <= 300).toBe(true);
        for (const other of placed.slice(i + 1)) expect(overlaps(box, other.box)).toBe(false);
      });
    }),
  );
});

test("who has more weight gets the place that both want", () => {
  const places = [{ x: 50, y: 50 }];
  const both = [
    { key: "light", width: 20, height: 10, weight: 1, places },
    { key: "heavy", width: 20, height: 10, weight: 2, places },
  ];
  expect(placeLabels(both, new TakenBoxes(), kScreen).map(({ key }) => key)).toEqual(["heavy"]);
});

test("of free places the one that hides least is taken, the first of two alike", () => {
  const places = [
    { x: 50, y: 50 },
    { x: 50, y: 100 },
    { x: 50, y: 150 },
  ];
  const cost = ({ yMin }: { yMin: number }): number => (yMin < 60 ? 3 : 1);
  const [placed] = placeLabels([{ key: 0, width: 20, height: 10, weight: 1, places, cost }], new TakenBoxes(), kScreen);
  expect(placed?.middle).toEqual({ x: 50, y: 100 });
});

test("what stands too close for a name each is one group, also by way of a third", () => {
  const column = [0, 10, 20].map((y) => ({ x: 0, y }));
  const apart = { x: 0, y: 60 };
  expect(clustersOf([column[0]!, column[2]!, apart, column[1]!])).toEqual([[column[0], column[2], column[1]], [apart]]);
  expect(
    clustersOf([
      { x: 0, y: 0 },
      { x: 0, y: 14 },
    ]),
  ).toHaveLength(2);
  const point = fc.record({ x: fc.integer({ max: 500 }), y: fc.integer({ max: 500 }) });
  fc.assert(
    fc.property(fc.array(point, { maxLength: 30 }), (points) => {
      expect(new Set(clustersOf(points).flat())).toEqual(new Set(points));
      expect(clustersOf(points).flat()).toHaveLength(points.length);
    }),
  );
});
