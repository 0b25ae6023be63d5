import fc from "fast-check";
import { expect, test } from "vitest";
import { type Box, boxOf } from "./geometry.ts";
import { SpatialIndex } from "./spatial_index.ts";

const coordinate = fc.integer({ min: -500, max: 500 });
const box: fc.Arbitrary<Box> = fc
  .tuple(coordinate, coordinate, coordinate, coordinate)
  .map(([a, b, c, d]) => boxOf({ x: a, y: b }, { x: c, y: d }));

function touches(a: Box, b: Box): boolean {
  return a.xMin <= b.xMax && b.xMin <= a.xMax && a.yMin <= b.yMax && b.yMin <= a.yMax;
}

test("it finds what looking at everything finds", () => {
  fc.assert(
    fc.property(fc.array(box, { maxLength: 60 }), box, (boxes, wanted) => {
      const index = new SpatialIndex(boxes.map((one, item) => ({ box: one, item })));
      expect(index.within(wanted)).toEqual([...boxes.keys()].filter((i) => touches(boxes[i]!, wanted)));
    }),
  );
});
