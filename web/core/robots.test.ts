import fc from "fast-check";
import { expect, test } from "vitest";
import { kRecordBytes, RobotTable, writeRecord } from "./robots.ts";

const robot = fc.record({
  id: fc.integer({ min: 1, max: 20000 }),
  x: fc.float({ noNaN: true, noDefaultInfinity: true }),
  y: fc.float({ noNaN: true, noDefaultInfinity: true }),
  heading: fc.double({ min: -10, max: 10, noNaN: true }),
  flags: fc.integer({ min: 0, max: 255 }),
});
const team = fc.uniqueArray(robot, { selector: (one) => one.id, maxLength: 200 });

function pack(robots: readonly { id: number; x: number; y: number; heading: number; flags: number }[]): Uint8Array {
  const bytes = new Uint8Array(robots.length * kRecordBytes);
  const view = new DataView(bytes.buffer);
  robots.forEach((one, row) => {
    writeRecord(view, row, one);
  });
  return bytes;
}

test("what was written into a frame is read from it", () => {
  fc.assert(
    fc.property(fc.array(team, { maxLength: 4 }), (frames) => {
      const table = new RobotTable();
      for (const robots of frames) {
        table.accept(pack(robots));
        expect(table.count).toBe(robots.length);
        for (const one of robots) {
          const row = table.rowOf(one.id);
          expect([table.id(row), table.x(row), table.y(row), table.flags(row)]).toEqual([
            one.id,
            one.x,
            one.y,
            one.flags,
          ]);
          expect(Math.cos(table.heading(row) - one.heading)).toBeGreaterThan(0.99999);
        }
      }
    }),
  );
});

test("a robot that the newest frame leaves out has no row", () => {
  const table = new RobotTable();
  const one = { id: 7, x: 1, y: 2, heading: 0, flags: 1 };
  table.accept(pack([one, { ...one, id: 8 }]));
  table.accept(pack([{ ...one, id: 8 }]));
  expect(table.rowOf(7)).toBe(-1);
  expect(table.rowOf(8)).toBe(0);
  expect(table.rowOf(999_999)).toBe(-1);
});

test("bytes that end within a record don't count", () => {
  const table = new RobotTable();
  table.accept(pack([{ id: 1, x: 0, y: 0, heading: 0, flags: 0 }]).subarray(0, 15));
  expect(table.count).toBe(0);
});
