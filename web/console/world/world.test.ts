import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { gridFor, nudgeOf, snapPoint } from "../map_editing/snap.ts";
import { editName, gripAt, type Thing, withRadius } from "../map_editing/things.ts";
import { defaultRandomObstacles, expectedCount, problemsOf, radiusLimits, seedFrom } from "./random_obstacles.ts";

const kArea = { width: 1000, height: 800 };

describe("the grid", () => {
  it("moves nothing that is on it, and everything else by half a step at most", () => {
    fc.assert(
      fc.property(
        fc.double({ min: -1e5, max: 1e5, noNaN: true }),
        fc.constantFrom(0.1, 0.5, 1, 2, 5, 10),
        (v, grid) => {
          const once = snapPoint({ x: v, y: v }, grid);
          expect(snapPoint(once, grid)).toEqual(once);
          expect(Math.abs(once.x - v)).toBeLessThanOrEqual(grid / 2 + 1e-6);
        },
      ),
    );
    expect(snapPoint({ x: 1.23, y: 4.56 }, 0)).toEqual({ x: 1.23, y: 4.56 });
  });
  it("fits the zoom", () => {
    expect(gridFor(1)).toBe(20);
    expect(gridFor(0.01)).toBe(0.2);
    expect(gridFor(Number.NaN)).toBe(1);
    fc.assert(
      fc.property(fc.double({ min: 1e-3, max: 100, noNaN: true }), (mpp) => {
        const pixels = gridFor(mpp) / mpp;
        expect(pixels).toBeGreaterThanOrEqual(11.9);
        expect(pixels).toBeLessThanOrEqual(30.1);
      }),
    );
  });
  it("is the step of arrow keys", () => {
    expect(nudgeOf("ArrowUp", false, 5, 1)).toEqual({ dx: 0, dy: 5 });
    expect(nudgeOf("ArrowLeft", true, 0, 0.5)).toEqual({ dx: -5, dy: 0 });
    expect(nudgeOf("a", false, 5, 1)).toBeNull();
  });
});

describe("random obstacles", () => {
  it("begin with the historic settings where the area allows them", () => {
    expect(defaultRandomObstacles(kArea)).toEqual({ coverage: 3, minRadius: 2, maxRadius: 10, seed: 0, replace: true });
    const room = defaultRandomObstacles({ width: 15, height: 10 });
    expect(problemsOf(room, { width: 15, height: 10 }, 1).errors).toEqual([]);
  });
  it("are counted from the mean disc", () => {
    const all = { coverage: 3, minRadius: 5, maxRadius: 5, seed: 1, replace: true };
    expect(expectedCount(all, kArea, [])).toBe(Math.ceil(24000 / (25 * Math.PI)));
    expect(expectedCount({ ...all, replace: false }, kArea, [100])).toBe(0);
    expect(expectedCount({ ...all, coverage: 0 }, kArea, [])).toBe(0);
  });
  it("say what is wrong", () => {
    const good = defaultRandomObstacles(kArea);
    expect(problemsOf(good, kArea, 50)).toEqual({ errors: [], warnings: [] });
    expect(problemsOf({ ...good, coverage: 31 }, kArea, 1).errors).toHaveLength(1);
    expect(problemsOf({ ...good, minRadius: 11 }, kArea, 1).errors).toHaveLength(1);
    expect(problemsOf({ ...good, maxRadius: 500 }, kArea, 1).errors).toHaveLength(1);
    expect(problemsOf({ ...good, seed: 1.5 }, kArea, 1).errors).toHaveLength(1);
    expect(problemsOf({ ...good, coverage: Number.NaN }, kArea, 0).errors).toHaveLength(1);
    expect(problemsOf({ ...good, coverage: 25 }, kArea, 200).warnings).toHaveLength(2);
    expect(radiusLimits(kArea)).toEqual({ min: 0.8, max: 160 });
  });
  it("get seeds that are never 0", () => {
    fc.assert(
      fc.property(fc.integer(), (bits) => {
        const seed = seedFrom(bits);
        expect(seed).toBeGreaterThan(0);
        expect(seed).toBeLessThan(1e6);
      }),
    );
  });
});

describe("things", () => {
  const obstacle = (index: number, x: number, radius: number): Thing => ({
    type: "obstacle",
    index,
    x,
    y: 0,
    radius,
    height: 1,
    document: "a.odl",
  });
  const things = [obstacle(0, 0, 50), obstacle(1, 10, 3)];
  it("on top of large ones can be reached", () => {
    expect(gripAt(things, null, { x: 11, y: 0 }, 1)?.thing.index).toBe(1);
    expect(gripAt(things, null, { x: 30, y: 0 }, 1)?.thing.index).toBe(0);
    expect(gripAt(things, null, { x: 99, y: 0 }, 1)).toBeNull();
  });
  it("are resized at the edge of the selected one", () => {
    expect(gripAt(things, "obstacle/1", { x: 13, y: 0 }, 1)).toMatchObject({ grip: "edge", thing: { index: 1 } });
    expect(withRadius(things[1] as Thing, 7)).toMatchObject({ radius: 7 });
    expect(
      withRadius({ type: "object", index: 0, x: 0, y: 0, diameter: 1, style: "fixed", color: "red", document: "" }, 2),
    ).toMatchObject({ diameter: 4 });
  });
  it("are named in undo", () => {
    expect(editName("move", [things[1] as Thing])).toBe("move obstacle 2");
    expect(editName("remove", things)).toBe("remove 2 things");
  });
});
