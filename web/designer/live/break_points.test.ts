import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { BreakpointSchema, Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import { atCondition, atTransition, breakpointText, onPort, onTransition } from "./break_points.ts";

const made = (init: Parameters<typeof create<typeof BreakpointSchema>>[1]) => create(BreakpointSchema, init);
const way = made(atTransition("movement", "Searching", "Acquiring"));
const near = made(atCondition("movement.near", Comparison.EQUAL, "true"));
const far = made(atCondition("movement.range", Comparison.GREATER, "2"));

test("breakpoints are told in words", () => {
  expect(breakpointText(way)).toBe("Searching → Acquiring");
  expect(breakpointText(made(atTransition("", "", "Acquiring")))).toBe("any state → Acquiring");
  expect(breakpointText(near)).toBe("near is true");
  expect(breakpointText(far)).toBe("range > 2");
});

test("the one on a transition or a port is found", () => {
  const all = [way, near, far];
  expect(onTransition(all, "movement", "Searching", "Acquiring")).toBe(way);
  expect(onTransition(all, "other", "Searching", "Acquiring")).toBeUndefined();
  expect(onTransition(all, "", "Searching", "Acquiring")).toBe(way);
  expect(onPort(all, "movement.near")).toEqual([near]);
});
