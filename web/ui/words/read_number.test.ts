import { describe, expect, it } from "vitest";
import { readNumber } from "./read_number.ts";

const problem = (text: string, isOptional = false) => readNumber(text, 0, 50, isOptional).problem;

describe("a number that is typed", () => {
  it("may have a comma, and bounds are numbers that may stand there", () => {
    expect([" 1,5 ", "0", "50", "1e1"].map((text) => readNumber(text, 0, 50))).toEqual(
      [1.5, 0, 50, 10].map((number) => ({ number, problem: undefined })),
    );
  });
  it("says why it is none, or may not stand there", () => {
    expect(["x", "NaN", "1.2.3", "Infinity"].map((text) => problem(text))).toEqual(Array(4).fill("This is no number."));
    expect([problem("-1"), problem("51")]).toEqual(["At least 0.", "At most 50."]);
  });
  it("may be left out where that means something", () => {
    expect([problem(" "), problem(" ", true)]).toEqual(["A number is needed.", undefined]);
  });
});
