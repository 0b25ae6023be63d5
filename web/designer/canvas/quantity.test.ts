import { expect, test } from "vitest";
import { numberIn, sliderValue } from "./quantity.ts";

test("a slider finds the number of what is written", () => {
  expect(numberIn("2 m")).toBe(2);
  expect(numberIn("-.5")).toBe(-0.5);
  expect(numberIn("36 km/h")).toBe(36);
  expect(numberIn("Orange")).toBeUndefined();
  expect(numberIn("[1, 2]")).toBeUndefined();
});

test("a slider keeps the unit that was written", () => {
  expect(sliderValue(1.23456, "50 cm", "m")).toBe("1.23 cm");
  expect(sliderValue(2, "1", "m")).toBe("2 m");
  expect(sliderValue(0.8, "0.5", "")).toBe("0.8");
});
