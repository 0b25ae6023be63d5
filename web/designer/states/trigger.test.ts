import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { DrawingSchema } from "../session/protocol.ts";
import { joinedPart, suppliersOf, termIn, termOf } from "./trigger.ts";

const operand = (index: number) => ({ name: "operand", index, isList: true });
// Near() and not IsAtGoal(DetectGoal())
const drawing = create(DrawingSchema, {
  resultNode: "And",
  nodes: [
    { name: "And", component: "and", inputs: [operand(0), operand(1), { name: "operand", isList: true }] },
    { name: "Near", component: "Near" },
    { name: "Not", component: "not", inputs: [{ name: "operand" }] },
    { name: "IsAtGoal", component: "IsAtGoal", inputs: [{ name: "goal" }] },
    { name: "DetectGoal", component: "DetectGoal" },
  ],
  wires: [
    { from: "Near", to: "And", port: "operand", index: 0 },
    { from: "Not", to: "And", port: "operand", index: 1 },
    { from: "IsAtGoal", to: "Not", port: "operand" },
    { from: "DetectGoal", to: "IsAtGoal", port: "goal" },
  ],
});
const whole = termOf(drawing);

test("a trigger is a tree of questions", () => {
  expect(whole?.terms.map((one) => one.node?.name)).toEqual(["Near", "Not"]);
  expect(termIn(whole, [1, 0])?.node?.name).toBe("IsAtGoal");
  expect(termIn(whole, [1, 0])?.terms).toEqual([]);
  expect(termIn(whole, [0, 3])).toBeUndefined();
});

test("what gives a question its inputs is no question", () => {
  expect(suppliersOf(drawing, termIn(whole, [1, 0])!.node!).map((one) => one.name)).toEqual(["DetectGoal"]);
});

test("where a joined trigger stands", () => {
  expect(joinedPart(whole, [], "and")).toEqual([2]);
  expect(joinedPart(whole, [], "or")).toEqual([1]);
  expect(joinedPart(whole, [0], "and")).toEqual([1]);
  expect(joinedPart(whole, [0], "or")).toEqual([0, 1]);
  expect(joinedPart(whole, [1, 0], "and")).toEqual([1, 0, 1]);
});
