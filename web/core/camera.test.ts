import fc from "fast-check";
import { expect, test } from "vitest";
import { Camera } from "./camera.ts";
import { distance } from "./geometry.ts";

const place = fc.record({
  x: fc.double({ min: -5000, max: 5000, noNaN: true }),
  y: fc.double({ min: -5000, max: 5000, noNaN: true }),
});
const camera = fc
  .record({
    at: place,
    scale: fc.double({ min: 0.01, max: 500, noNaN: true }),
    width: fc.integer({ min: 100, max: 4000 }),
    height: fc.integer({ min: 100, max: 3000 }),
  })
  .map(({ at, scale, width, height }) => {
    const made = new Camera();
    made.resize(width, height);
    made.scale = scale;
    made.lookAt(at);
    return made;
  });

test("what goes to the screen comes back to the same place", () => {
  fc.assert(
    fc.property(camera, place, (one, world) => {
      expect(distance(one.toWorld(one.toScreen(world)), world)).toBeLessThan(1e-6);
    }),
  );
});

test("north is up and east is right", () => {
  const one = new Camera();
  one.resize(200, 100);
  expect(one.toScreen({ x: 0, y: 0 })).toEqual({ x: 100, y: 50 });
  expect(one.toScreen({ x: 10, y: 20 })).toEqual({ x: 110, y: 30 });
});

test("zooming leaves what is under the pointer where it is", () => {
  fc.assert(
    fc.property(
      camera,
      fc.record({ x: fc.integer({ min: 0, max: 100 }), y: fc.integer({ min: 0, max: 100 }) }),
      fc.double({ min: 0.2, max: 5, noNaN: true }),
      (one, pointer, factor) => {
        const before = one.toWorld(pointer);
        one.zoomAbout(pointer, factor);
        expect(distance(one.toScreen(before), pointer)).toBeLessThan(1e-5);
      },
    ),
  );
});

test("panning moves everything by what was dragged", () => {
  fc.assert(
    fc.property(camera, place, (one, world) => {
      const before = one.toScreen(world);
      one.pan(17, -9);
      const after = one.toScreen(world);
      expect(after.x - before.x).toBeCloseTo(17, 5);
      expect(after.y - before.y).toBeCloseTo(-9, 5);
    }),
  );
});

test("a box that was fitted is seen whole, and no larger than it has to be", () => {
  fc.assert(
    fc.property(camera, place, place, (one, a, b) => {
      fc.pre(Math.abs(a.x - b.x) > 0.5 && Math.abs(a.y - b.y) > 0.5);
      const box = {
        xMin: Math.min(a.x, b.x),
        yMin: Math.min(a.y, b.y),
        xMax: Math.max(a.x, b.x),
        yMax: Math.max(a.y, b.y),
      };
      one.fit(box, 20);
      const seen = one.visible();
      expect(seen.xMin).toBeLessThanOrEqual(box.xMin + 1e-6);
      expect(seen.yMax).toBeGreaterThanOrEqual(box.yMax - 1e-6);
      const spare = Math.min(
        one.width - (box.xMax - box.xMin) * one.scale,
        one.height - (box.yMax - box.yMin) * one.scale,
      );
      expect(spare).toBeLessThanOrEqual(41);
    }),
  );
});

test("what is fitted keeps clear of what covers the screen, where that leaves room", () => {
  const one = new Camera();
  one.resize(1000, 700);
  const area = { xMin: 0, yMin: 0, xMax: 1000, yMax: 800 };
  const bar = { xMin: 12, yMin: 12, xMax: 52, yMax: 450 };
  const question = { xMin: 676, yMin: 12, xMax: 988, yMax: 130 };
  one.fit(area, 40, [bar, question]);
  expect(one.toScreenX(area.xMin)).toBeGreaterThanOrEqual(bar.xMax);
  expect(one.toScreenY(area.yMax)).toBeGreaterThanOrEqual(question.yMax);
  expect(one.visible().yMin).toBeLessThanOrEqual(area.yMin);
  // Nothing is left beside this one.
  const without = new Camera();
  without.resize(1000, 700);
  without.fit(area);
  one.fit(area, 40, [{ xMin: 10, yMin: 10, xMax: 990, yMax: 690 }]);
  expect(one.saved()).toEqual(without.saved());
});

test("a saved view comes back", () => {
  fc.assert(
    fc.property(camera, (one) => {
      const saved = one.saved();
      one.pan(100, 50);
      one.zoomAbout({ x: 3, y: 4 }, 2);
      one.restore(saved);
      expect(one.saved()).toEqual(saved);
    }),
  );
});
