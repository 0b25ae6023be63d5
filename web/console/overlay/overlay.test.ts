import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { kindInfo, kindOfWire, kKinds, kLineKinds, type MeasureKind } from "../../core/measure_kinds.ts";
import { Measure_Kind } from "../../core/protocol.ts";
import {
  addPoint,
  circleDraft,
  emptyDraft,
  guidance,
  hallwayPoints,
  isFull,
  measurePoints,
  missingInDraft,
  removeLastPoint,
} from "./draft.ts";
import { nameProblem, proposeName } from "./names.ts";
import { odlText, parsePoints, pointLines } from "./odl_text.ts";
import { dragHandle, handlesOf, moveAll, removeCorner } from "./vertices.ts";

const kPoint = fc.record({
  x: fc.integer({ min: -100000, max: 100000 }).map((v) => v / 100),
  y: fc.integer({ min: -100000, max: 100000 }).map((v) => v / 100),
});
const kKind = fc.constantFrom(...kKinds.map((k) => k.kind));

describe("kinds", () => {
  it("are all that the protocol has, each once", () => {
    const wires = Object.values(Measure_Kind).filter((value) => typeof value === "number");
    expect(kKinds.map((k) => k.wire).sort((a, b) => a - b)).toEqual(wires);
    expect(new Set(kKinds.map((k) => k.keyword)).size).toBe(wires.length);
    expect(kindOfWire(99)).toBeUndefined();
  });
  it("have lines to follow that are no points", () => {
    for (const kind of kLineKinds) expect(kindInfo(kind).shape).not.toBe("point");
  });
});

describe("a draft", () => {
  it("takes points until the kind has enough", () => {
    fc.assert(
      fc.property(kKind, fc.array(kPoint, { maxLength: 12 }), (kind, points) => {
        let draft = emptyDraft(kind);
        for (const p of points) draft = addPoint(draft, p, -1);
        expect(draft.points).toEqual(points.slice(0, kindInfo(kind).maxPoints));
        expect(isFull(draft)).toBe(draft.points.length === kindInfo(kind).maxPoints);
        expect(guidance(draft)).not.toBe("");
      }),
    );
  });

  it("ignores the second click of a double click", () => {
    const draft = addPoint(addPoint(emptyDraft("axis"), { x: 1, y: 1 }), { x: 1.1, y: 1 }, 0.5);
    expect(draft.points).toHaveLength(1);
  });

  it("says what is missing", () => {
    let draft = emptyDraft("axis");
    expect(missingInDraft(draft)).toBe("Needs 2 more points.");
    draft = addPoint(draft, { x: 0, y: 0 });
    expect(missingInDraft(draft)).toBe("Needs one more point.");
    expect(missingInDraft(addPoint(draft, { x: 5, y: 5 }))).toBe("");
    let area = addPoint(emptyDraft("assembly_area"), { x: 0, y: 0 });
    expect(missingInDraft(area)).toBe("");
    area = addPoint(area, { x: 5, y: 5 });
    expect(missingInDraft(area)).toMatch(/three/);
    expect(missingInDraft(removeLastPoint(area))).toBe("");
    const zone = addPoint(addPoint(emptyDraft("landing_zone"), { x: 0, y: 0 }), { x: 5, y: 5 });
    expect(missingInDraft(zone)).toBe("Needs one more point.");
    expect(missingInDraft(addPoint(zone, { x: 5, y: 0 }))).toBe("");
  });

  it("becomes a circle by a drag", () => {
    expect(circleDraft("objective", { x: 10, y: 10 }, { x: 13, y: 14 })).toEqual({
      kind: "objective",
      points: [{ x: 10, y: 10 }],
      size: 10,
    });
  });

  it("of a hallway gets corners round its centre line", () => {
    const { points, centerline } = hallwayPoints(
      [
        { x: 0, y: 0 },
        { x: 10, y: 0 },
      ],
      2,
    );
    expect(centerline).toHaveLength(2);
    expect(points).toEqual([
      { x: 0, y: 1 },
      { x: 10, y: 1 },
      { x: 10, y: -1 },
      { x: 0, y: -1 },
    ]);
    expect(
      measurePoints({
        kind: "hallway",
        points: [
          { x: 1, y: 1 },
          { x: 1, y: 1 },
        ],
        size: 0,
      }).points,
    ).toHaveLength(4);
  });
});

/** Reads a statement back, as docs/languages/odl.md says: an odd count of numbers ends with the size. */
function readBack(text: string): { keyword: string; name: string; points: { x: number; y: number }[]; size: number } {
  const found = /^(\S+) ("[^"]*"|\S+) (.*)$/.exec(text);
  if (!found) throw new Error(text);
  const numbers = (found[3] as string).split(/\s+/).map(Number);
  const size = numbers.length % 2 === 1 ? (numbers.pop() as number) : 0;
  const points = [];
  for (let i = 0; i < numbers.length; i += 2) points.push({ x: numbers[i] as number, y: numbers[i + 1] as number });
  return { keyword: found[1] as string, name: found[2] as string, points, size };
}

describe("odlText", () => {
  it("is what a person would write", () => {
    const base = { points: [{ x: 350, y: 400 }], centerline: [], showsLabel: true };
    expect(odlText({ ...base, kind: "passage_point", name: "Charlie", size: 10 })).toBe("PP Charlie 350 400 10");
    expect(odlText({ ...base, kind: "start_point", name: "two words", showsLabel: false, size: 3 })).toBe(
      'SP "two words*" 350 400',
    );
    expect(odlText({ ...base, kind: "objective", name: "", size: 0 })).toBe('OBJ "" 350 400');
    const { points, centerline } = hallwayPoints(
      [
        { x: 0, y: 0 },
        { x: 10, y: 0 },
      ],
      2,
    );
    expect(odlText({ kind: "hallway", name: "h", showsLabel: true, points, centerline, size: 2 })).toBe(
      "HALLWAY h CENTERLINE 0 0  10 0 WIDTH 2 EXTENTS 0 1  10 1  10 -1  0 -1",
    );
  });

  it("keeps all points and the size of what is drawn", () => {
    const drawn = kKind.filter((k) => k !== "hallway");
    fc.assert(
      fc.property(
        drawn,
        fc.array(kPoint, { minLength: 1, maxLength: 9 }),
        fc.integer({ min: 0, max: 500 }),
        (kind, points, size) => {
          let draft = emptyDraft(kind);
          for (const p of points) draft = addPoint(draft, p, -1);
          const read = readBack(odlText({ kind, name: "n", showsLabel: true, ...measurePoints(draft), size }));
          expect(read.keyword).toBe(kindInfo(kind).keyword);
          expect(read.points).toEqual(draft.points.map((p) => ({ x: p.x + 0, y: p.y + 0 })));
          expect(read.size).toBe(kindInfo(kind).sizeLabel === "" ? 0 : size);
        },
      ),
    );
  });
});

describe("parsePoints", () => {
  it("reads what pointLines writes", () => {
    fc.assert(
      fc.property(fc.array(kPoint), (points) => {
        expect(parsePoints(pointLines(points))).toEqual({ points: points.map((p) => ({ x: p.x + 0, y: p.y + 0 })) });
      }),
    );
  });
  it("takes what people type and says what it does not understand", () => {
    expect(parsePoints("(1, 2); 3 .5")).toEqual({
      points: [
        { x: 1, y: 2 },
        { x: 3, y: 0.5 },
      ],
    });
    expect(parsePoints("1 2 3")).toHaveProperty("error");
    expect(parsePoints("1 two")).toEqual({ error: "two is no number." });
    expect(parsePoints("1 0x10")).toHaveProperty("error");
    expect(parsePoints("1 1e12")).toHaveProperty("error");
  });
});

describe("handles", () => {
  it("move, add and remove points, and undo each other", () => {
    const before = {
      points: [
        { x: 0, y: 0 },
        { x: 10, y: 0 },
        { x: 10, y: 10 },
      ],
      size: 0,
    };
    const moved = dragHandle(before, { type: "corner", index: 1 }, { x: 10, y: 0 }, { x: 20, y: 0 });
    expect(moved.points[1]).toEqual({ x: 20, y: 0 });
    const added = dragHandle(before, { type: "middle", after: 2 }, { x: 5, y: 5 }, { x: 0, y: 10 });
    expect(added.points).toHaveLength(4);
    expect(removeCorner("assembly_area", added, 3)).toEqual(before);
    expect(removeCorner("assembly_area", before, 0)).toBeNull();
    expect(removeCorner("axis", before, 0)?.points).toHaveLength(2);
    expect(removeCorner("axis", before, 7)).toBeNull();
  });

  it("are at each point, between points where one more may be, and at the edge of a circle", () => {
    const count = (kind: MeasureKind, n: number) =>
      handlesOf(
        kind,
        Array.from({ length: n }, (_, i) => ({ x: i, y: 0 })),
        0,
      ).length;
    expect(count("assembly_area", 1)).toBe(2);
    expect(count("assembly_area", 4)).toBe(8);
    expect(count("axis", 3)).toBe(5);
    expect(count("gap", 2)).toBe(2);
    expect(count("start_point", 1)).toBe(1);
  });

  it("that resize a circle keep its middle", () => {
    const before = { points: [{ x: 5, y: 5 }], size: 10 };
    expect(dragHandle(before, { type: "radius" }, { x: 10, y: 5 }, { x: 5, y: 25 })).toEqual({ ...before, size: 40 });
  });

  it("that move the whole keep its form", () => {
    fc.assert(
      fc.property(fc.array(kPoint), kPoint, (points, by) => {
        const there = moveAll({ points, size: 1 }, by.x, by.y);
        const back = moveAll(there, -by.x, -by.y);
        back.points.forEach((p, i) => {
          expect(p.x).toBeCloseTo(points[i]?.x as number, 6);
          expect(p.y).toBeCloseTo(points[i]?.y as number, 6);
        });
      }),
    );
  });
});

describe("names", () => {
  it("are proposed with the first free number", () => {
    expect(proposeName("assembly_area", [])).toBe("AA-1");
    expect(proposeName("passage_point", ["PP-1", "pp-2", "PP-4"])).toBe("PP-3");
  });
  it("that are proposed are never a problem", () => {
    fc.assert(
      fc.property(kKind, fc.array(fc.string()), (kind, taken) => {
        expect(nameProblem(proposeName(kind, taken), taken)).toEqual({ error: "", warning: "" });
      }),
    );
  });
  it("are refused where they can't be written or found", () => {
    expect(nameProblem("a", ["a"]).error).not.toBe("");
    expect(nameProblem('a"', []).error).not.toBe("");
    expect(nameProblem("a*", []).error).not.toBe("");
    expect(nameProblem(" a", []).error).not.toBe("");
    expect(nameProblem("A", ["a"]).warning).not.toBe("");
    expect(nameProblem("", []).warning).not.toBe("");
  });
});
