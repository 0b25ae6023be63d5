import fc from "fast-check";
import { expect, test } from "vitest";
import { formatAngle, formatBearing, formatDistance, formatDuration, formatPlace, roundDown } from "./format.ts";

test("distances have as many digits as one wants to read", () => {
  expect([0.035, 0.35, 0, 1.234, 12.34, 123.4, 1234, 12345].map(formatDistance)).toEqual([
    "3.5 cm",
    "35 cm",
    "0.00 m",
    "1.23 m",
    "12.3 m",
    "123 m",
    "1.23 km",
    "12.3 km",
  ]);
  expect(formatDistance(Number.NaN)).toBe("–");
});

test("durations turn into minutes and hours", () => {
  expect([0, 4.25, 59.99, 65, 3723, -1].map(formatDuration)).toEqual([
    "0.0 s",
    "4.3 s",
    "1:00",
    "1:05",
    "1:02:03",
    "–",
  ]);
});

test("angles count from east against the clock, bearings from north with it", () => {
  expect([formatAngle(0), formatAngle(Math.PI / 2), formatAngle(-Math.PI / 2)]).toEqual(["0°", "90°", "270°"]);
  expect([formatBearing(0), formatBearing(Math.PI / 2), formatBearing(Math.PI)]).toEqual(["090°", "000°", "270°"]);
});

test("a place has no digits that the screen can't show", () => {
  expect(formatPlace(12.3456, 7, 0.5)).toBe("12, 7 m");
  expect(formatPlace(12.3456, 7, 80)).toBe("12.35, 7.00 m");
});

test("a round number is below what was given, by less than a factor of two and a half", () => {
  fc.assert(
    fc.property(fc.double({ min: 1e-6, max: 1e6, noNaN: true }), (most) => {
      const round = roundDown(most);
      expect(round).toBeLessThanOrEqual(most * (1 + 1e-9));
      expect(round * 2.5).toBeGreaterThanOrEqual(most * (1 - 1e-9));
    }),
  );
});
