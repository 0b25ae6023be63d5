import { describe, expect, it } from "vitest";
import {
  flowOf,
  formatOf,
  isWholeNumber,
  kParameterTypeNames,
  kQuantityNames,
  kSensedTypeNames,
} from "./value_types.ts";

describe("flowOf", () => {
  it("tells quantities by what they are kept in", () => {
    expect([flowOf("length"), flowOf("flag"), flowOf("text")]).toEqual(["number", "flag", "text"]);
  });
  it("looks through lists, constants and template arguments", () => {
    expect(flowOf("list of Object")).toBe("thing");
    expect(flowOf("const double")).toBe("number");
    expect(flowOf("Vector<3>")).toBe("movement");
  });
  it("takes a library's own types for things by their names, else for percepts", () => {
    expect(flowOf("DoorReading")).toBe("thing");
    expect(flowOf("Weather")).toBe("percept");
  });
});

describe("lists of types", () => {
  it("offers for parameters all quantities, and for sensors none", () => {
    expect(kParameterTypeNames).toEqual([...kQuantityNames, "Object", "Vector", "Point"]);
    expect(kSensedTypeNames.filter((name) => kQuantityNames.includes(name))).toEqual([]);
    expect(kSensedTypeNames).toContain("Obstacles");
  });
});

describe("a value's form", () => {
  it("tells whole numbers from others", () => {
    expect([isWholeNumber("count"), isWholeNumber("int"), isWholeNumber("double")]).toEqual([true, true, false]);
  });
  it("is told where nobody could guess it", () => {
    expect(formatOf("Vector")).toBe("ahead, left");
    expect(formatOf("double")).toBe("");
  });
});
