import { describe, expect, it } from "vitest";
import { addressedUnits } from "./addressed.ts";

const kUnits = [
  { name: "scouts", robots: [1, 2, 3, 4] },
  { name: "left", robots: [1, 2] },
  { name: "right", robots: [3, 4] },
];

const of = (unit: string, ...robots: number[]) => addressedUnits({ unit, robots }, kUnits);

describe("a command by mouse", () => {
  it("goes to the selected unit", () => {
    expect(of("left", 1, 2)).toEqual({ units: ["left"], robots: [], note: "" });
  });
  it("goes to the largest units that are selected as a whole", () => {
    expect(of("", 4, 3, 2, 1).units).toEqual(["scouts"]);
    expect(of("", 3, 4)).toEqual({ units: ["right"], robots: [], note: "" });
  });
  it("goes to the selected robots and nobody else where they are no whole units", () => {
    expect(of("", 3)).toEqual({ units: [], robots: [3], note: "" });
    expect(of("", 3, 1, 2)).toEqual({ units: [], robots: [1, 2, 3], note: "" });
    expect(of("", 9)).toEqual({ units: [], robots: [9], note: "" });
  });
  it("goes to the only unit there is where nothing is selected", () => {
    expect(of("").units).toEqual(["scouts"]);
    const none = addressedUnits({ unit: "", robots: [] }, kUnits.slice(1));
    expect(none).toEqual({ units: [], robots: [], note: expect.stringMatching(/Select a unit or robots/) });
  });
});
