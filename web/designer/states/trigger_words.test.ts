import { expect, test } from "vitest";
import { labelLines } from "./label.ts";
import { isNoTrigger, triggerText, triggerWords } from "./trigger_words.ts";

test.each([
  ["Constant()", "at once"],
  ["Constant(value = true)", "at once"],
  [" true ", "at once"],
  ["Constant(value = false)", "no trigger yet"],
  ["Constant(false)", "no trigger yet"],
  ["not Constant()", "not Constant()"],
  ["IsHalted()", "IsHalted()"],
  ["", ""],
])("%s is read as %s", (trigger, words) => {
  expect(triggerWords(trigger)).toBe(words);
});

test("what is typed in words is CDL again, whatever its case", () => {
  for (const words of ["at once", "no trigger yet"]) expect(triggerWords(triggerText(words))).toBe(words);
  for (const words of ["", "Never"]) expect(isNoTrigger(triggerText(words))).toBe(true);
  expect(triggerText("Immediate")).toBe("Constant()");
  expect(triggerText("IsHalted()")).toBe("IsHalted()");
});

test("the drawing says the words", () => {
  expect(labelLines("Constant(value = false)")).toEqual(["no trigger yet"]);
  expect(labelLines("Constant()", true)).toEqual(["at once"]);
});
