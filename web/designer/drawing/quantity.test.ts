import { expect, test } from "vitest";
import { numberIn, sliderValue } from "./quantity.ts";

test("a slider finds the number of what is written", () => {
  expect(numberIn("2 m", "m")).toBe(2);
  expect(numberIn("2")).toBe(2);
  expect(numberIn("-.5")).toBe(-0.5);
  expect(numberIn("Orange")).toBeUndefined();
  expect(numberIn("[1, 2]")).toBeUndefined();
});

test("a slider stands where the value is, whatever unit it is written in", () => {
  expect(numberIn("50 cm", "m")).toBe(0.5);
  expect(numberIn("36 km/h", "m/s")).toBe(10);
  expect(numberIn("90 deg/s", "rad/s")).toBeCloseTo(Math.PI / 2, 10);
  expect(numberIn("2 s", "m")).toBeUndefined();
  expect(numberIn("1 m", "m/s")).toBeUndefined();
});

test("a slider keeps the unit that was written, and means the same by it", () => {
  expect(sliderValue(1.23456, "50 cm", "m")).toBe("123 cm");
  expect(sliderValue(2, "1", "m")).toBe("2 m");
  expect(sliderValue(0.8, "0.5", "")).toBe("0.8");
  expect(sliderValue(10, "1 km/h", "m/s")).toBe("36 km/h");
});
