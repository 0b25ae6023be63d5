import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { BreakpointSchema, Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import { atCondition, atSentence, atTransition, breakpointText, hitText } from "./break_points.ts";

const made = (init: Parameters<typeof create<typeof BreakpointSchema>>[1]) => create(BreakpointSchema, init);
const way = made(atTransition("movement", "Searching", "Acquiring"));
const near = made(atCondition("movement.near", Comparison.EQUAL, "true"));
const far = made(atCondition("movement.range", Comparison.GREATER, "2"));

test("breakpoints are told in words", () => {
  expect(breakpointText(way)).toBe("Searching → Acquiring");
  expect(breakpointText(made(atTransition("", "", "Acquiring")))).toBe("any state → Acquiring");
  expect(breakpointText(near)).toBe("near is true");
  expect(breakpointText(far)).toBe("range > 2");
  expect(breakpointText(made(atSentence("any robot in contact")))).toBe("any robot in contact");
});

test("what has stopped the run is told as people call it", () => {
  const hit = { robot: 1, text: "robot 1 touched something", sequence: "", from: "", to: "", port: "", value: "" };
  expect(hitText({ ...hit, port: "movement.Searching.value.near", value: "true" })).toBe(
    "robot 1: Searching: near is true",
  );
  expect(hitText({ ...hit, sequence: "movement", from: "Searching", to: "Acquiring" })).toBe(
    "robot 1: movement goes from Searching to Acquiring",
  );
  expect(hitText(hit)).toBe("robot 1 touched something");
});
