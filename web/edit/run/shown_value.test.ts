import { expect, test } from "vitest";
import { shownText, shownVector } from "./shown_value.ts";

test("numbers have three digits and their unit", () => {
  expect(shownText("0.123456789", "m")).toBe("0.123 m");
  expect(shownText("89.99999999", "deg")).toBe("90 deg");
  expect(shownText("12", "")).toBe("12");
});

test("words stay, and digits in names too", () => {
  expect(shownText("true", "")).toBe("true");
  expect(shownText("Robot2", "m")).toBe("Robot2");
  expect(shownText("Mine", "m")).toBe("Mine");
});

test("what is infinite or no number is told as that", () => {
  expect(shownText("inf", "m")).toBe("∞ m");
  expect(shownText("-inf", "")).toBe("-∞");
  expect(shownText("(inf, -inf)", "")).toBe("(∞, -∞)");
  expect(shownText("nan", "m")).toBe("no number");
  expect(shownText("Infantry", "")).toBe("Infantry");
});

test("what is long is cut", () => {
  expect(shownText("[1.5, 2.25, 3.125, 4.0625, 5, 6, 7, 8, 9]", "").length).toBeLessThanOrEqual(26);
});

test("a vector is told by its length", () => {
  expect(shownVector(3, -4, "m")).toBe("5 m");
  expect(shownVector(0, 0, "")).toBe("0");
});
