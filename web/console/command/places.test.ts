import { describe, expect, it } from "vitest";
import { nearestLine, type PlaceMeasure, placeFor, referenceTo, snapToCenter } from "./places.ts";

const m = (kind: PlaceMeasure["kind"], name: string, ...xy: number[]): PlaceMeasure => ({
  kind,
  name,
  size: 0,
  points: Array.from({ length: xy.length / 2 }, (_, i) => ({ x: xy[2 * i] as number, y: xy[2 * i + 1] as number })),
});

describe("places", () => {
  const measures = [
    m("passage_point", "Charlie", 100, 100),
    m("assembly_area", "two words", 0, 0, 10, 0, 10, 10, 0, 10),
    m("passage_point", "twice", 50, 50),
    m("passage_point", "twice", 60, 60),
    m("start_point", "", 1, 1),
    m("axis", "AXIS-Golf", 0, 200, 100, 200),
    m("gap", "g", 0, 1, 0, 2),
    m("room", "GAP-g", 0, 300),
    m("landing_zone", "Eagle", 0, 400, 9, 400, 9, 409),
    m("landing_zone", "LANDING-ZONE-1", 0, 500, 9, 500, 9, 509),
  ];

  it("are referred to as missions do, where that finds them", () => {
    expect(measures.map((_, i) => referenceTo(measures, i))).toEqual([
      "PP-Charlie",
      "two words",
      null,
      "PP-twice",
      null,
      "AXIS-Golf",
      "g",
      "ROOM-GAP-g",
      "LANDING-ZONE-Eagle",
      "LANDING-ZONE-1",
    ]);
  });

  it("snap to the nearest centre within reach", () => {
    expect(snapToCenter(measures, { x: 98, y: 101 }, 5)).toBe(0);
    expect(snapToCenter(measures, { x: 5, y: 6 }, 5)).toBe(1);
    expect(snapToCenter(measures, { x: 80, y: 80 }, 5)).toBeNull();
    expect(nearestLine(measures, { x: 40, y: 203 }, 5)).toBe(5);
    expect(nearestLine(measures, { x: 40, y: 230 }, 5)).toBeNull();
  });

  it("become coordinates of the mission where there is no name", () => {
    expect(placeFor(measures, null, { x: 310.123, y: 205.04 }, { x: 10, y: 5 }, 1)).toEqual({ x: 300.1, y: 200 });
    expect(placeFor(measures, 2, { x: 51, y: 51 }, { x: 0, y: 0 }, 1)).toEqual({ x: 50, y: 50 });
    expect(placeFor(measures, 0, { x: 51, y: 51 }, { x: 0, y: 0 }, 1)).toEqual({ reference: "PP-Charlie" });
  });
});
