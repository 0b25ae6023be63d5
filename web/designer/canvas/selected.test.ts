import { expect, test } from "vitest";
import { selectionAfter, stillThere } from "./selected.ts";

const chosen = (id: string, selected: boolean) => ({ type: "select" as const, id, selected });

test("what is chosen is added, what is let go of is taken away, the rest keeps its order", () => {
  const before = ["Noise", "Probe", "cooperate"];
  expect(selectionAfter(before, [chosen("Probe", false), chosen("spread", true)])).toEqual([
    "Noise",
    "cooperate",
    "spread",
  ]);
  expect(selectionAfter(before, [chosen("Noise", true)])).toEqual(before);
});

test("what is only moved or measured is not a selection", () => {
  const before = ["Noise"];
  expect(selectionAfter(before, [{ type: "position", id: "Probe", position: { x: 0, y: 0 } }])).toBe(before);
});

test("what has gone from the page is not selected any more", () => {
  const before = ["Noise", "Probe"];
  expect(stillThere(before, new Set(["Noise", "Probe", "spread"]))).toBe(before);
  expect(stillThere(before, new Set(["Probe"]))).toEqual(["Probe"]);
});
