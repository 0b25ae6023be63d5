import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decimalsFor, headingOfDrag, type MouseCommand, mdlName, mdlNumber, mdlText } from "./mdl_text.ts";

const kCommand: MouseCommand = {
  units: ["scouts"],
  robots: [],
  task: "MOVETO",
  place: { x: 310, y: 205 },
  formation: "Wedge",
  technique: "",
  speed: 0,
  heading: 45,
  more: [],
  swath: 0,
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
    expect(textOf({ ...all, task: "RALLY" })).toEqual({ text: "UNIT scouts RALLY 310 205 SPEED 3" });
    expect(textOf({ ...all, task: "OCCUPY" })).toEqual({
      text: "UNIT scouts OCCUPY 310 205 FORMATION Wedge HEADING 45",
    });
    expect(textOf({ ...all, task: "SWEEPTO", formation: "" })).toEqual({
      text: "UNIT scouts SWEEPTO 310 205 TECHNIQUE Traveling SPEED 3",
    });
  });

  it("writes several places where the task takes them", () => {
    const more = [{ reference: "PP-B" }, { x: 1.5, y: 2 }];
    expect(textOf({ task: "VISIT", more })).toEqual({ text: "UNIT scouts VISIT 310 205 PP-B 1.5 2" });
    expect(textOf({ task: "MOVETO", more, heading: null, formation: "" })).toEqual({
      text: "UNIT scouts MOVETO 310 205",
    });
    expect(textOf({ task: "PATROL", more: [] })).toHaveProperty("error");
  });

  it("searches areas, by their names", () => {
    expect(textOf({ task: "SEARCH", place: { reference: "OBJ-Field" }, swath: 20 })).toEqual({
      text: "UNIT scouts SEARCH OBJ-Field SWATH 20",
    });
    expect(textOf({ task: "SEARCH" })).toHaveProperty("error");
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
