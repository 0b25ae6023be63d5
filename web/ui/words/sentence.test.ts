import { expect, test } from "vitest";
import { sentence, withoutBackticks } from "./sentence.ts";

test("a sentence begins with a capital and ends with a stop", () => {
  expect(["", "no robot 3", "what?", "Wait…"].map((text) => sentence(text))).toEqual([
    "",
    "No Robot 3.",
    "What?",
    "Wait…",
  ]);
});

test("the name of a file stays as it is written", () => {
  expect(sentence("forage.cdl is gone")).toBe("forage.cdl is gone.");
});

test("names stand in quotes, or without marks", () => {
  expect(sentence("`a` is not known")).toBe("“a” is not known.");
  expect(sentence("`a` is not known", withoutBackticks)).toBe("A is not known.");
});
