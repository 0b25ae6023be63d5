import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { pageKey } from "../session/pages.ts";
import { type Drawing, Drawing_Kind, DrawingSchema } from "../session/protocol.ts";
import { createState } from "../session/state.ts";
import { kTourSteps } from "./steps.ts";

function stateWith(drawing: Drawing) {
  const store = createState(localStorage, 1280);
  store.setState({ document: "new:1", page: "Wander", drawings: { [pageKey("new:1", "Wander")]: drawing } });
  return store.getState();
}
const step = (title: string) => kTourSteps.find((one) => one.title === title)!;

test("steps know when they are done, by what stands in the drawing", () => {
  const empty = create(DrawingSchema, { kind: Drawing_Kind.DATAFLOW });
  expect(step("A first skill").isDone!(stateWith(empty))).toBe(true);
  expect(step("Three motor schemas").isDone!(stateWith(empty))).toBe(false);
  const nodes = ["Noise", "AvoidStaticObstacles", "Probe", "cooperate"].map((component) => ({
    name: component,
    component,
  }));
  const placed = create(DrawingSchema, { kind: Drawing_Kind.DATAFLOW, nodes });
  expect(step("Three motor schemas").isDone!(stateWith(placed))).toBe(true);
  expect(step("Wires").isDone!(stateWith(placed))).toBe(false);
  const wires = nodes.slice(0, 3).map((node, index) => ({ from: node.name, to: "cooperate", port: "members", index }));
  const wired = create(DrawingSchema, { kind: Drawing_Kind.DATAFLOW, nodes, wires, resultNode: "cooperate" });
  expect(step("Wires").isDone!(stateWith(wired))).toBe(true);
  expect(step("Eyes").isDone!(stateWith(wired))).toBe(false);
  expect(step("The result").isDone!(stateWith(wired))).toBe(true);
});

test("a step shows which component comes next", () => {
  const one = create(DrawingSchema, { kind: Drawing_Kind.DATAFLOW, nodes: [{ name: "Noise", component: "Noise" }] });
  const { next } = step("Three motor schemas");
  expect(next!(stateWith(create(DrawingSchema, { kind: Drawing_Kind.DATAFLOW })))).toBe("Noise");
  expect(next!(stateWith(one))).toBe("AvoidStaticObstacles");
  expect(step("Eyes").next!(stateWith(one))).toBe("sense_obstacles");
});
