import { create } from "@bufbuild/protobuf";
import fc from "fast-check";
import { expect, test } from "vitest";
import { TrailsSchema } from "./protocol.ts";
import { kRecordBytes, RobotTable, writeRecord } from "./robots.ts";
import { Trail, TrailStore } from "./trails.ts";

function tableOf(x: number, y: number): RobotTable {
  const bytes = new Uint8Array(kRecordBytes);
  writeRecord(new DataView(bytes.buffer), 0, { id: 5, x, y, heading: 0, flags: 1 });
  const table = new RobotTable();
  table.accept(bytes);
  return table;
}

test("a trail keeps the newest of what it was given, in order", () => {
  fc.assert(
    fc.property(fc.integer({ min: 1, max: 100 }), fc.integer({ min: 0, max: 400 }), (capacity, count) => {
      const trail = new Trail(capacity);
      for (let i = 0; i < count; ++i) trail.add(i, -i, i * 2);
      expect(trail.count).toBe(Math.min(capacity, count));
      for (let i = 0; i < trail.count; ++i) {
        const number = count - trail.count + i;
        expect([trail.x(i), trail.y(i), trail.time(i)]).toEqual([number, -number, number * 2]);
      }
    }),
  );
});

test("a trail goes on from points that are taken over as from points that were added", () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 50 }),
      fc.integer({ min: 0, max: 120 }),
      fc.integer({ min: 0, max: 120 }),
      fc.integer({ min: 0, max: 2 }),
      (capacity, before, after, rest) => {
        const points = Float32Array.from({ length: before * 3 + rest }, (_, i) => i);
        const taken = new Trail(capacity, points);
        const added = new Trail(capacity);
        for (let i = 0; i < before; ++i) added.add(points[i * 3]!, points[i * 3 + 1]!, points[i * 3 + 2]!);
        for (const trail of [taken, added]) {
          trail.cut(before * 2);
          for (let i = 0; i < after; ++i) trail.add(i, -i, 1000 + i);
        }
        const read = (trail: Trail) =>
          Array.from({ length: trail.count }, (_, i) => [trail.x(i), trail.y(i), trail.time(i)]);
        expect(read(taken)).toEqual(read(added));
      },
    ),
  );
});

test("who stands leaves no new points", () => {
  const store = new TrailStore();
  for (let time = 0; time < 50; ++time) store.extend(tableOf(3, 4), time);
  expect(store.get(5)?.count).toBe(1);
  store.extend(tableOf(4, 4), 51);
  expect(store.get(5)?.count).toBe(2);
});

test("what the server remembers replaces what was known", () => {
  const store = new TrailStore();
  store.extend(tableOf(0, 0), 0);
  const before = store.generation;
  const points = new Uint8Array(new Float32Array([1, 2, 0, 3, 4, 1]).buffer);
  store.replace(create(TrailsSchema, { trails: [{ robot: 9, points }] }));
  expect(store.get(5)).toBeUndefined();
  expect(store.get(9)?.x(1)).toBe(3);
  expect(store.generation).toBeGreaterThan(before);
});

test("many robots have short trails", () => {
  const store = new TrailStore(1000, 500);
  store.fitTo(100, 1000);
  for (let i = 0; i < 100; ++i) store.extend(tableOf(i, 0), i);
  expect(store.get(5)?.count).toBe(16);
});
