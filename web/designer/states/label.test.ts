import fc from "fast-check";
import { expect, test } from "vitest";
import { kScales, labelLines, labelSize, scaleAt } from "./label.ts";

test("a short trigger is one line, a long one is broken where one would breathe", () => {
  expect(labelLines("IsHalted()")).toEqual(["IsHalted()"]);
  expect(labelLines("IsAtGoal(home_place, success_radius = 6 m)")).toEqual([
    "IsAtGoal(home_place,",
    "success_radius = 6 m)",
  ]);
  expect(labelLines("IsAtGoal(DetectGoal(back), success_radius = 1 m) or IsHalted()")).toHaveLength(3);
  expect(labelLines("")).toEqual(["when?"]);
});

test("no line is longer than can be read, and nothing is lost but behind an ellipsis", () => {
  fc.assert(
    fc.property(fc.string({ maxLength: 120, unit: "grapheme-ascii" }), (trigger) => {
      const lines = labelLines(trigger);
      expect(lines.length).toBeLessThanOrEqual(3);
      for (const line of lines) expect(line.length).toBeLessThanOrEqual(30);
      const whole = (trigger.trim().replaceAll(/\s+/g, " ") || "when?").replaceAll(" ", "");
      const written = lines.join("").replaceAll(" ", "");
      expect(written.endsWith("…") ? whole.startsWith(written.slice(0, -1)) : whole === written).toBe(true);
    }),
  );
});

test("a label takes more room the farther away it is looked at from", () => {
  const lines = labelLines("IsValidObject(target)");
  expect(labelSize(lines, 1, scaleAt(0.5)).width).toBeGreaterThan(labelSize(lines, 1, scaleAt(1)).width);
  expect(labelSize(labelLines("a".repeat(99)), 0).height).toBeGreaterThan(labelSize(["a"], 0).height);
  expect(kScales).toContain(scaleAt(0.1));
  for (const zoom of [0.34, 0.4, 0.5, 0.6, 0.7, 0.8, 1]) expect(12 * zoom * scaleAt(zoom)).toBeGreaterThan(9.9);
});
