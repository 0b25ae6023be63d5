import { expect, test } from "vitest";
import { endWords, fieldLabel, limitWords, typeWords, withUnit } from "./value_words.ts";

test("types and units are said in words", () => {
  expect(typeWords("double", "s")).toBe("a number, in seconds");
  expect(typeWords("int", "")).toBe("a whole number");
  expect(typeWords("bool", "")).toBe("true or false");
  expect(typeWords("Vector", "m")).toBe("Vector, in metres");
  expect(typeWords("double", "kg m")).toBe("a number, in kg m");
});

test("the label of a field says its unit", () => {
  expect(fieldLabel("persistence", "double", "s")).toBe("persistence, in seconds");
  expect(fieldLabel("gain", "double", "")).toBe("gain, a number");
  expect(fieldLabel("readings", "Obstacles", "")).toBe("readings, Obstacles");
  expect(fieldLabel("member", "", "")).toBe("member");
});

test("range and default are said, ends that mean none are not", () => {
  expect(limitWords({ min: 0, max: 100, initial: "6", unit: "s" })).toBe("0 s to 100 s, default 6 s.");
  expect(limitWords({ min: 0, max: 1e9, initial: "", unit: "m" })).toBe("At least 0 m.");
  expect(limitWords({ initial: "Orange", unit: "" })).toBe("Default Orange.");
  expect(limitWords({ initial: "", unit: "" })).toBe("");
});

test("angles are said in degrees", () => {
  expect(endWords(Math.PI, "rad")).toBe("180 deg");
  expect(limitWords({ min: -7, max: 7, initial: "90 deg", unit: "rad" })).toBe("-401 deg to 401 deg, default 90 deg.");
});

test("only bare numbers get a unit", () => {
  expect(withUnit("10", "s")).toBe("10 s");
  expect(withUnit("-.5", "m")).toBe("-.5 m");
  expect(withUnit("50 cm", "m")).toBe("50 cm");
  expect(withUnit("Orange", "m")).toBe("Orange");
  expect(withUnit("1.2.3", "m")).toBe("1.2.3");
  expect(limitWords({ initial: "1.2.3", unit: "m" })).toBe("Default 1.2.3.");
});
