import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Port_Role, PortSchema, RobotDetail_ContributionSchema } from "../../core/protocol.ts";
import { kSliderEnd, placeOnSlider, valueOnSlider } from "../../core/slider_scale.ts";
import { isSwitchedOn, parameterKind, parameterProblem, sliderOf, valueNumber } from "./parameter.ts";
import { portGroups, spacedName, splitPath } from "./ports.ts";
import { vectorSums } from "./why.ts";

const port = (path: string, role: Port_Role, more = {}) =>
  create(PortSchema, { path, role, type: "double", isNumber: true, ...more });

const ports = [
  port("goal.gain", Port_Role.PARAMETER, { help: "strength of the pull" }),
  port("avoid.sphere", Port_Role.PARAMETER),
  port("goal.output", Port_Role.OUTPUT, { type: "Vector", isNumber: false }),
  port("speed", Port_Role.OUTPUT),
];

describe("the ports of a robot", () => {
  it("are grouped by node, in the program's order, and keep their index", () => {
    const groups = portGroups(ports, "", "all");
    expect(groups.map((group) => group.node)).toEqual(["goal", "avoid", ""]);
    expect(groups[0]?.rows.map((row) => row.index)).toEqual([0, 2]);
  });
  it("are found by any words of path, type and help", () => {
    expect(portGroups(ports, "pull goal", "all").flatMap((group) => group.rows.map((row) => row.name))).toEqual([
      "gain",
    ]);
    expect(portGroups(ports, "nothing like it", "all")).toEqual([]);
  });
  it("are told apart by what they are for", () => {
    expect(portGroups(ports, "", "parameters").flatMap((group) => group.rows)).toHaveLength(2);
    expect(portGroups(ports, "", "outputs").flatMap((group) => group.rows)).toHaveLength(2);
  });
  it("have paths with points or slashes", () => {
    expect(splitPath("a/b.c")).toEqual({ node: "a/b", name: "c" });
    expect(splitPath("c")).toEqual({ node: "", name: "c" });
    expect(spacedName("base_gain")).toBe("base gain");
  });
});

describe("a parameter", () => {
  it("is a slider where the author gave a range", () => {
    expect(parameterKind(port("a", Port_Role.PARAMETER, { min: 0, max: 5 }))).toBe("slider");
    expect(parameterKind(port("a", Port_Role.PARAMETER))).toBe("number");
    expect(parameterKind(port("a", Port_Role.PARAMETER, { choices: ["x"] }))).toBe("choice");
    expect(parameterKind(port("a", Port_Role.PARAMETER, { type: "bool", isNumber: false }))).toBe("switch");
  });
  it("has its usual value well inside of the slider, however wide the range", () => {
    const wide = sliderOf(port("a", Port_Role.PARAMETER, { min: 0, max: 100, initial: "0.8" }));
    expect(placeOnSlider(wide, 0.8)).toBe(400);
    expect([valueOnSlider(wide, 0), valueOnSlider(wide, kSliderEnd)]).toEqual([0, 100]);
    const even = sliderOf(port("a", Port_Role.PARAMETER, { min: 0, max: 5, initial: "2" }));
    expect(valueOnSlider(even, 500)).toBe(2.5);
  });
  it("keeps whole numbers whole", () => {
    const curve = sliderOf(port("a", Port_Role.PARAMETER, { min: 0, max: 10, type: "int", initial: "5" }));
    expect(valueOnSlider(curve, 333)).toBe(3);
  });
  it("refuses what is outside of its range and what is no number", () => {
    const ranged = port("a", Port_Role.PARAMETER, { min: 0, max: 5 });
    expect(parameterProblem(ranged, "6")).toBe("At most 5.");
    expect(parameterProblem(ranged, "much")).toBe("A number is needed.");
    expect(parameterProblem(ranged, " 2.5 ")).toBeUndefined();
  });
  it("is read from what a person sees", () => {
    expect(valueNumber("2.5 m")).toBe(2.5);
    expect(valueNumber("-1e-3")).toBe(-0.001);
    expect(valueNumber("east")).toBeNaN();
    expect([isSwitchedOn("true"), isSwitchedOn("1"), isSwitchedOn("off")]).toEqual([true, true, false]);
  });
});

describe("why", () => {
  it("adds the parts of each sum and says how large each share is", () => {
    const [sum] = vectorSums([
      create(RobotDetail_ContributionSchema, { sum: "move", member: "goal", x: 1, y: 0 }),
      create(RobotDetail_ContributionSchema, { sum: "move", member: "avoid", x: -0.5, y: 0.5 }),
    ]);
    expect(sum).toMatchObject({ name: "move", x: 0.5, y: 0.5 });
    expect(sum?.members.map((member) => member.name)).toEqual(["goal", "avoid"]);
    expect(sum?.members[0]?.share).toBe(1);
    expect(sum?.members[1]?.size).toBeCloseTo(Math.SQRT1_2);
  });
  it("calls a part against the sum's direction opposing", () => {
    const [sum] = vectorSums([
      create(RobotDetail_ContributionSchema, { sum: "move", member: "goal", x: 2, y: 0 }),
      create(RobotDetail_ContributionSchema, { sum: "move", member: "avoid", x: -1, y: 0 }),
      create(RobotDetail_ContributionSchema, { sum: "move", member: "noise", x: 0, y: 0 }),
    ]);
    expect(sum?.members.map((member) => member.effect)).toEqual(["with", "against", "none"]);
  });
  it("has nothing to say where nothing moves the robot", () => expect(vectorSums([])).toEqual([]));
});
