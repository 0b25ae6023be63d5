import { create, type MessageInitShape } from "@bufbuild/protobuf";
import { describe, expect, test } from "vitest";
import { kDefaultSettings, withLayer } from "../map_settings.ts";
import { Measure_Kind as K, type Measure, MeasureSchema, SceneSchema } from "../protocol.ts";
import { labelOf } from "./measure_names.ts";
import { axisOutline, boxOfMeasure, distanceTo, gapRails, shapeOf } from "./measure_shape.ts";
import { SceneIndex } from "./picking.ts";

function measure(init: MessageInitShape<typeof MeasureSchema>): Measure {
  return create(MeasureSchema, { showsLabel: true, ...init });
}

describe("shapes", () => {
  test("an area of one point is a circle of its diameter, 50 m where none was given", () => {
    const points = [{ x: 10, y: 20 }];
    expect(shapeOf(measure({ kind: K.OBJECTIVE, points, size: 80 }))).toEqual({
      kind: "circle",
      centre: points[0] && expect.objectContaining(points[0]),
      radius: 40,
    });
    expect(shapeOf(measure({ kind: K.ASSEMBLY_AREA, points }))).toMatchObject({ radius: 25 });
  });

  test("an axis is an arrow whose tip is its last point and whose shaft is as wide as it says", () => {
    const axis = measure({
      kind: K.AXIS,
      points: [
        { x: 0, y: 0 },
        { x: 100, y: 0 },
      ],
      size: 20,
    });
    const outline = axisOutline(axis);
    expect(outline).toContainEqual(expect.objectContaining({ x: 100, y: 0 }));
    expect(outline[0]).toEqual({ x: 0, y: 10 });
    expect(outline.at(-1)).toEqual({ x: 0, y: -10 });
    expect(Math.max(...outline.map(({ y }) => y))).toBeCloseTo(14);
  });

  test("a gap's rails lie on both sides, half its width away, and flare outward", () => {
    const rails = gapRails(
      measure({
        kind: K.GAP,
        points: [
          { x: 0, y: 0 },
          { x: 50, y: 0 },
        ],
        size: 40,
      }),
    );
    expect(rails.map((rail) => rail[1]!.y)).toEqual([20, -20]);
    expect(rails[0]![0]!.y).toBeGreaterThan(20);
    expect(rails[1]![3]!.y).toBeLessThan(-20);
  });

  test("a measure without points has no shape, and is nowhere near", () => {
    for (const kind of Object.values(K).filter((value) => typeof value === "number")) {
      const empty = measure({ kind });
      expect(shapeOf(empty)).toBeNull();
      expect(boxOfMeasure(empty)).toBeNull();
      expect(distanceTo(empty, { x: 0, y: 0 }, 1).edge).toBe(Infinity);
    }
  });

  test("every kind of one point has a shape and a box that holds it", () => {
    for (const kind of Object.values(K).filter((value) => typeof value === "number")) {
      const one = measure({ kind, points: [{ x: 3, y: 4 }] });
      expect(shapeOf(one)).not.toBeNull();
      const box = boxOfMeasure(one)!;
      expect(box.xMin <= 3 && box.xMax >= 3 && box.yMin <= 4 && box.yMax >= 4).toBe(true);
    }
  });
});

describe("names", () => {
  test("the plain style tells kinds of lines, the military one every kind, and no code twice", () => {
    const phase = measure({ kind: K.PHASE_LINE, name: "Gamma" });
    const area = measure({ kind: K.ASSEMBLY_AREA, name: "AA1" });
    expect([labelOf(phase, false), labelOf(area, false)]).toEqual(["PL Gamma", "AA1"]);
    expect([labelOf(phase, true), labelOf(area, true)]).toEqual(["PL GAMMA", "AA 1"]);
    expect(labelOf(measure({ kind: K.OBJECTIVE, name: "Tango" }), true)).toBe("OBJ TANGO");
    expect(labelOf(measure({ kind: K.OBJECTIVE, name: "Tango", showsLabel: false }), true)).toBe("");
    const zone = measure({ kind: K.LANDING_ZONE, name: "Eagle" });
    expect([labelOf(zone, false), labelOf(zone, true)]).toEqual(["Eagle", "LZ EAGLE"]);
  });
});

describe("picking", () => {
  const scene = create(SceneSchema, {
    width: 200,
    height: 200,
    measures: [
      { kind: K.OBJECTIVE, name: "large", points: [{ x: 100, y: 100 }], size: 150 },
      { kind: K.BATTLE_POSITION, name: "small", points: [{ x: 100, y: 100 }], size: 40 },
      {
        kind: K.WALL,
        name: "wall",
        points: [
          { x: 90, y: 100 },
          { x: 110, y: 100 },
        ],
      },
    ],
    obstacles: [{ x: 100, y: 104, radius: 2 }],
  });
  const index = new SceneIndex(scene);
  const names = (x: number, y: number): string[] =>
    index
      .near({ x, y }, 1, kDefaultSettings)
      .map(({ kind, index: i }) => (kind === "measure" ? scene.measures[i]!.name : kind));

  test("small things come before the areas that they lie in", () => {
    expect(names(100, 104)).toEqual(["obstacle", "small", "large"]);
    expect(names(95, 100)).toEqual(["wall", "small", "large"]);
    expect(names(150, 100)).toEqual(["large"]);
    expect(names(199, 199)).toEqual([]);
  });

  test("what is not shown can't be picked", () => {
    const hidden = withLayer(kDefaultSettings, "measures", false);
    expect(index.near({ x: 100, y: 104 }, 1, hidden)).toEqual([{ kind: "obstacle", index: 0 }]);
  });

  test("a box takes what lies wholly inside", () => {
    const box = { xMin: 70, yMin: 70, xMax: 130, yMax: 130 };
    expect(index.inside(box, kDefaultSettings)).toEqual([
      { kind: "measure", index: 1 },
      { kind: "measure", index: 2 },
      { kind: "obstacle", index: 0 },
    ]);
  });
});
