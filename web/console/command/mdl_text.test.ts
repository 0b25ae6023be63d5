import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decimalsFor, headingOfDrag, type MouseCommand, mdlName, mdlNumber, mdlText } from "./mdl_text.ts";
import { nearestLine, type PlaceMeasure, placeFor, referenceTo, snapToCenter } from "./places.ts";

const kCommand: MouseCommand = {
  units: ["scouts"],
  robots: [],
  task: "MOVETO",
  place: { x: 310, y: 205 },
  formation: "Wedge",
  technique: "",
  speed: 0,
  heading: 45,
};

const textOf = (c: Partial<MouseCommand>) => mdlText({ ...kCommand, ...c });

describe("mdlText", () => {
  it("writes what a person would type", () => {
    expect(textOf({})).toEqual({ text: "UNIT scouts MOVETO 310 205 FORMATION Wedge HEADING 45" });
    expect(
      textOf({ place: { reference: "PP-Charlie" }, technique: "Bounding-Overwatch", speed: 2.5, heading: null }),
    ).toEqual({
      text: "UNIT scouts MOVETO PP-Charlie FORMATION Wedge TECHNIQUE Bounding-Overwatch SPEED 2.5",
    });
  });

  it("leaves out clauses that the task does not take", () => {
    const all = { technique: "Traveling", speed: 3 } as const;
    expect(textOf({ ...all, task: "OCCUPY" })).toEqual({
      text: "UNIT scouts OCCUPY 310 205 FORMATION Wedge HEADING 45",
    });
    expect(textOf({ ...all, task: "SWEEPTO", formation: "" })).toEqual({
      text: "UNIT scouts SWEEPTO 310 205 TECHNIQUE Traveling SPEED 3",
    });
  });

  it("names robots by their numbers", () => {
    expect(textOf({ units: [], robots: [3], formation: "", heading: null })).toEqual({
      text: "ROBOT 3 MOVETO 310 205",
    });
    expect(textOf({ units: [], robots: [2, 5, 7], formation: "Line", heading: null })).toEqual({
      text: "ROBOTS 2 5 7 MOVETO 310 205 FORMATION Line",
    });
  });

  it("joins the commands of several units", () => {
    expect(textOf({ units: ["a", "my unit"], formation: "", heading: null })).toEqual({
      text: 'UNIT a MOVETO 310 205 AND UNIT "my unit" MOVETO 310 205',
    });
  });

  it("says what is missing", () => {
    expect(textOf({ units: [] })).toHaveProperty("error");
    expect(textOf({ task: "FOLLOW" })).toHaveProperty("error");
    expect(textOf({ place: { x: Number.NaN, y: 1 } })).toHaveProperty("error");
    expect(textOf({ units: ['a"b'] })).toHaveProperty("error");
  });
});

describe("mdlNumber", () => {
  it("is a number of MDL and means the value", () => {
    fc.assert(
      fc.property(fc.double({ min: -1e8, max: 1e8, noNaN: true }), (value) => {
        const text = mdlNumber(value);
        expect(text).toMatch(/^-?\d+(\.\d+)?$/);
        expect(Math.abs(Number(text) - value)).toBeLessThanOrEqual(0.0005 + 1e-7);
      }),
    );
    expect(mdlNumber(-0.0001)).toBe("0");
    expect(mdlNumber(100)).toBe("100");
  });
});

describe("mdlName", () => {
  it("quotes what is no word", () => {
    expect(mdlName("AA-1_b")).toBe("AA-1_b");
    expect(mdlName("north wall")).toBe('"north wall"');
    expect(mdlName("1st")).toBe('"1st"');
    expect(mdlName("")).toBeNull();
    expect(mdlName('a"')).toBeNull();
    expect(mdlName("a\nb")).toBeNull();
  });
});

describe("headingOfDrag", () => {
  it("counts counter-clockwise from east", () => {
    expect(headingOfDrag(1, 0, 5)).toBe(0);
    expect(headingOfDrag(0, 1, 5)).toBe(90);
    expect(headingOfDrag(0, -1, 5)).toBe(270);
    expect(headingOfDrag(1, -0.01, 5)).toBe(0);
  });
  it("is a whole step within a turn", () => {
    fc.assert(
      fc.property(
        fc.double({ min: -1e3, max: 1e3, noNaN: true }),
        fc.double({ min: -1e3, max: 1e3, noNaN: true }),
        (dx, dy) => {
          const h = headingOfDrag(dx, dy, 5);
          expect(h % 5).toBe(0);
          expect(h).toBeGreaterThanOrEqual(0);
          expect(h).toBeLessThan(360);
        },
      ),
    );
  });
});

describe("decimalsFor", () => {
  it("needs whole metres far out and centimetres in a room", () => {
    expect(decimalsFor(2)).toBe(0);
    expect(decimalsFor(0.1)).toBe(1);
    expect(decimalsFor(10)).toBe(0);
    expect(decimalsFor(0.01)).toBe(2);
    expect(decimalsFor(0)).toBe(3);
  });
});

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
