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
    expect(of("left", 1, 2)).toEqual({ units: ["left"], note: "" });
  });
  it("goes to the largest units that are selected as a whole", () => {
    expect(of("", 4, 3, 2, 1).units).toEqual(["scouts"]);
    expect(of("", 3, 4)).toEqual({ units: ["right"], note: "" });
  });
  it("says so when more robots are meant than were selected", () => {
    const one = of("", 3);
    expect(one.units).toEqual(["right"]);
    expect(one.note).toMatch(/all of right/);
    expect(of("", 1, 2, 3).units).toEqual(["left", "right"]);
  });
  it("goes to the only unit there is where nothing is selected", () => {
    expect(of("").units).toEqual(["scouts"]);
    expect(addressedUnits({ unit: "", robots: [] }, kUnits.slice(1)).units).toEqual([]);
  });
  it("says which robots can't be commanded", () => {
    expect(of("", 9)).toEqual({ units: [], note: expect.stringMatching(/Robot 9 is in no unit/) });
  });
});
