import fc from "fast-check";
import { expect, test } from "vitest";
import { momentSpoken, momentText, readMoment } from "./run_time.ts";

test("a moment is written and spoken to a tenth of a second", () => {
  expect([0, 7.04, 59.96, 133.4, 3723.4].map(momentText)).toEqual([
    "0:00.0",
    "0:07.0",
    "1:00.0",
    "2:13.4",
    "1:02:03.4",
  ]);
  expect([0, 59.96, 133.4, 3600, 3723.4].map(momentSpoken)).toEqual([
    "0.0 s",
    "1 min 0.0 s",
    "2 min 13.4 s",
    "1 h 0 min 0.0 s",
    "1 h 2 min 3.4 s",
  ]);
  expect(momentText(Number.NaN)).toBe("0:00.0");
});

test("a moment is read in every way in which people write one", () => {
  for (const text of ["2:13.4", "133.4", " 133.4 s", "2 min 13.4 s", "2min13.4s", "133,4", "0:02:13.4"])
    expect(readMoment(text), text).toBeCloseTo(133.4);
  expect(readMoment("1:02:03")).toBe(3723);
  expect(readMoment("2 min")).toBe(120);
  for (const text of ["", "soon", "2:61", "-3", "1:2:3:4", "2:", "s", "1e3"])
    expect(readMoment(text), text).toBeUndefined();
});

test("what is written is read as the same moment", () => {
  fc.assert(
    fc.property(fc.double({ min: 0, max: 360000, noNaN: true }), (seconds) => {
      expect(readMoment(momentText(seconds))).toBeCloseTo(Math.round(seconds * 10) / 10, 6);
      expect(readMoment(momentSpoken(seconds))).toBeCloseTo(Math.round(seconds * 10) / 10, 6);
    }),
  );
});
