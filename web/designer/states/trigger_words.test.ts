import { expect, test } from "vitest";
import { labelLines } from "./label.ts";
import { triggerText, triggerWords } from "./trigger_words.ts";

test.each([
  ["Constant()", "at once"],
  ["Constant(value = true)", "at once"],
  [" true ", "at once"],
  ["Constant(value = false)", "never"],
  ["Constant(false)", "never"],
  ["not Constant()", "not Constant()"],
  ["IsHalted()", "IsHalted()"],
  ["", ""],
])("%s is read as %s", (trigger, words) => {
  expect(triggerWords(trigger)).toBe(words);
});

test("what is typed in words is CDL again, whatever its case", () => {
  for (const words of ["at once", "never"]) expect(triggerWords(triggerText(words))).toBe(words);
  expect(triggerText("Immediate")).toBe("Constant()");
  expect(triggerText("IsHalted()")).toBe("IsHalted()");
});

test("the drawing says the words", () => {
  expect(labelLines("Constant(value = false)")).toEqual(["never"]);
  expect(labelLines("Constant()", true)).toEqual(["at once"]);
});
