import fc from "fast-check";
import { expect, test } from "vitest";
import { Glide, turnBetween } from "./glide.ts";
import { kRecordBytes, RobotTable, writeRecord } from "./robots.ts";

function wanted(): Glide {
  const glide = new Glide();
  glide.isWanted = true;
  return glide;
}

function pack(...robots: readonly { id: number; x: number; heading?: number }[]): Uint8Array {
  const bytes = new Uint8Array(robots.length * kRecordBytes);
  robots.forEach(({ id, x, heading = 0 }, row) => {
    writeRecord(new DataView(bytes.buffer), row, { id, x, y: -x, heading, flags: 1 });
  });
  return bytes;
}

test("at ten frames a second robots arrive when the next frame is due, and wait there", () => {
  const glide = wanted();
  glide.take(1000, 0.1);
  expect(glide.take(1100, 0.1)).toBeGreaterThan(0);
  expect(glide.share(1100)).toBe(0);
  expect(glide.share(1150)).toBeCloseTo(0.5);
  expect(glide.share(1200)).toBe(1);
  expect(glide.share(5000)).toBe(1);
});

test("frames that come thirty times a second or more often are shown as they are", () => {
  const glide = wanted();
  for (let now = 0; now < 1000; now += 33) expect(glide.take(now, 0.1)).toBe(0);
  expect(glide.share(1000)).toBe(1);
});

test("a run that stands or is stepped is shown as it is, and so is one after a long gap", () => {
  const glide = wanted();
  glide.take(0, 0.1);
  expect(glide.take(100, 0)).toBe(0);
  expect(glide.share(101)).toBe(1);
  expect(glide.take(9000, 0.1)).toBe(0);
});

test("nothing glides where the drawings cost too much", () => {
  const glide = new Glide();
  glide.take(0, 0.1);
  expect(glide.take(100, 0.1)).toBe(0);
});

test("the delay stays within one interval, however unevenly frames come", () => {
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 41, max: 400 }), { minLength: 2, maxLength: 40 }), (gaps) => {
      const glide = wanted();
      let now = 0;
      for (const gap of gaps) {
        glide.take(now, 0.1);
        now += gap;
      }
      glide.take(now, 0.1);
      expect(glide.share(now + Math.max(...gaps))).toBe(1);
    }),
  );
});

test("a turn takes the shorter way round and ends where it should", () => {
  expect(turnBetween(65000, 536, 0.5)).toBe(0);
  expect(turnBetween(536, 65000, 0.5)).toBe(0);
  const heading = fc.integer({ min: 0, max: 65535 });
  fc.assert(
    fc.property(heading, heading, fc.double({ min: 0, max: 1, noNaN: true }), (from, to, share) => {
      expect(turnBetween(from, to, 0)).toBe(from);
      expect(turnBetween(from, to, 1)).toBe(to);
      const away = (a: number, b: number): number => Math.min((a - b) & 0xffff, (b - a) & 0xffff);
      expect(away(from, turnBetween(from, to, share))).toBeLessThanOrEqual(away(from, to));
    }),
  );
});

test("a robot is on its way from where it was shown to where the newest frame has it", () => {
  const table = new RobotTable();
  table.accept(pack({ id: 1, x: 10 }, { id: 2, x: 0 }));
  table.accept(pack({ id: 2, x: 1, heading: 1 }, { id: 1, x: 11 }), 4);
  expect(table.x(table.rowOf(1))).toBe(11);
  table.share = 0.5;
  expect(table.x(table.rowOf(1))).toBe(10.5);
  expect(table.y(table.rowOf(1))).toBe(-10.5);
  expect(table.x(table.rowOf(2))).toBe(0.5);
  expect(table.heading(table.rowOf(2))).toBeCloseTo(0.5, 3);
  // The next frame comes early: nobody jumps.
  table.accept(pack({ id: 1, x: 12 }, { id: 2, x: 2 }), 4);
  table.share = 0;
  expect(table.x(table.rowOf(1))).toBe(10.5);
});

test("who was started or has jumped is where the frame says at once", () => {
  const table = new RobotTable();
  table.accept(pack({ id: 1, x: 10 }));
  table.accept(pack({ id: 1, x: 100 }, { id: 2, x: 5 }), 4);
  table.share = 0;
  expect([table.x(0), table.x(1)]).toEqual([100, 5]);
});

test("a frame that is to be shown as it is ends all ways", () => {
  const table = new RobotTable();
  table.accept(pack({ id: 1, x: 10 }));
  table.accept(pack({ id: 1, x: 11 }), 4);
  table.accept(pack({ id: 1, x: 12 }));
  table.share = 0.3;
  expect(table.share).toBe(1);
  expect(table.x(0)).toBe(12);
});
