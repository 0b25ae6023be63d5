import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  alongLine,
  angleBetween,
  type Box,
  boundsOf,
  boxOf,
  contains,
  crosses,
  distance,
  distanceToLine,
  distanceToSegment,
  isInside,
  lengthOf,
  offsetLine,
  overlaps,
  type Point,
} from "./geometry.ts";

const number = fc.double({ min: -1000, max: 1000, noNaN: true });
const point: fc.Arbitrary<Point> = fc.record({ x: number, y: number });
const line = fc.array(point, { minLength: 2, maxLength: 8 });

describe("distances", () => {
  test("a point of a segment is at no distance from it", () => {
    fc.assert(
      fc.property(point, point, fc.double({ min: 0, max: 1, noNaN: true }), (a, b, share) => {
        const on = { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share };
        expect(distanceToSegment(on, a, b)).toBeLessThan(1e-6);
      }),
    );
  });

  test("a line is never farther than its nearest corner", () => {
    fc.assert(
      fc.property(point, line, (from, points) => {
        const corner = Math.min(...points.map((one) => distance(from, one)));
        expect(distanceToLine(from, points)).toBeLessThanOrEqual(corner + 1e-9);
      }),
    );
  });

  test("nothing is near a line without points", () => {
    expect(distanceToLine({ x: 0, y: 0 }, [])).toBe(Infinity);
  });
});

describe("boxes", () => {
  test("the bounds of points hold all of them", () => {
    fc.assert(
      fc.property(line, (points) => {
        const box = boundsOf(points)!;
        for (const one of points) expect(contains(box, one)).toBe(true);
      }),
    );
    expect(boundsOf([])).toBeNull();
  });

  test("two boxes overlap each other or neither the other", () => {
    fc.assert(
      fc.property(point, point, point, point, (a, b, c, d) => {
        expect(overlaps(boxOf(a, b), boxOf(c, d))).toBe(overlaps(boxOf(c, d), boxOf(a, b)));
      }),
    );
  });

  test("a segment crosses a box when one of its points lies in it", () => {
    fc.assert(
      fc.property(point, point, point, point, (a, b, from, to) => {
        const box: Box = boxOf(a, b);
        const samples = Array.from({ length: 21 }, (_, i) => ({
          x: from.x + ((to.x - from.x) * i) / 20,
          y: from.y + ((to.y - from.y) * i) / 20,
        }));
        const inner = { xMin: box.xMin - 1e-9, yMin: box.yMin - 1e-9, xMax: box.xMax + 1e-9, yMax: box.yMax + 1e-9 };
        if (samples.some((one) => contains(box, one))) expect(crosses(inner, from, to)).toBe(true);
      }),
    );
    expect(crosses({ xMin: 0, yMin: 0, xMax: 1, yMax: 1 }, { x: 2, y: -1 }, { x: 2, y: 3 })).toBe(false);
  });
});

describe("lines", () => {
  test("going along the whole of a line ends at its last point", () => {
    fc.assert(
      fc.property(line, (points) => {
        fc.pre(lengthOf(points) > 1e-6);
        expect(distance(alongLine(points, lengthOf(points)).point, points.at(-1)!)).toBeLessThan(1e-6);
      }),
    );
    // What is left of the way, by rounding, is any multiple of a last step that is hardly one.
    const hooked = [
      { x: -0.00003095584679568418, y: 0 },
      { x: 0, y: 612.5952932945156 },
      { x: 0, y: 0 },
      { x: 0, y: -5e-324 },
    ];
    expect(distance(alongLine(hooked, lengthOf(hooked)).point, hooked.at(-1)!)).toBeLessThan(1e-6);
  });

  test("a straight line is moved aside by exactly what was asked", () => {
    fc.assert(
      fc.property(point, point, fc.double({ min: -50, max: 50, noNaN: true }), (a, b, by) => {
        fc.pre(distance(a, b) > 1e-3);
        const [c, d] = offsetLine([a, b], by);
        expect(distance(a, c!)).toBeCloseTo(Math.abs(by), 6);
        expect(distance(c!, d!)).toBeCloseTo(distance(a, b), 6);
      }),
    );
  });

  test("to the left is up, for a line to the east", () => {
    expect(
      offsetLine(
        [
          { x: 0, y: 0 },
          { x: 10, y: 0 },
        ],
        2,
      ),
    ).toEqual([
      { x: 0, y: 2 },
      { x: 10, y: 2 },
    ]);
  });

  test("a corner is never moved farther than its mitre allows", () => {
    fc.assert(
      fc.property(line, fc.double({ min: 0.1, max: 20, noNaN: true }), (points, by) => {
        const kept = points.filter((one, i) => i === 0 || distance(one, points[i - 1]!) > 0);
        fc.pre(kept.length > 1);
        offsetLine(points, by).forEach((moved, i) => {
          expect(distance(moved, kept[i]!)).toBeLessThanOrEqual(by * 4.01);
        });
      }),
    );
  });
});

test("a polygon holds its middle and not what is outside of its bounds", () => {
  const square = [
    { x: 0, y: 0 },
    { x: 4, y: 0 },
    { x: 4, y: 4 },
    { x: 0, y: 4 },
  ];
  expect(isInside({ x: 2, y: 2 }, square)).toBe(true);
  expect(isInside({ x: 5, y: 2 }, square)).toBe(false);
});

test("the angle between two headings is the short way round", () => {
  fc.assert(
    fc.property(number, number, (from, to) => {
      const turn = angleBetween(from, to);
      expect(Math.abs(turn)).toBeLessThanOrEqual(Math.PI + 1e-9);
      expect(Math.cos(from + turn)).toBeCloseTo(Math.cos(to), 6);
    }),
  );
});
