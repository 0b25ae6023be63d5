import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Drawing_Kind, DrawingSchema } from "../../designer/session/protocol.ts";
import { isWritten, parameterName, parametersBelow, targetOf } from "./targets.ts";

test("nodes, wires and the result have values", () => {
  const drawing = create(DrawingSchema, {
    kind: Drawing_Kind.DATAFLOW,
    nodes: [{ name: "Noise", live: "Noise", type: "Vector" }, { name: "text" }],
    wires: [
      { from: "Noise", to: "cooperate", port: "members", index: 0, live: "Noise", type: "Vector" },
      { from: "cooperate", to: "$result", live: ".", type: "Vector" },
    ],
  });
  expect(targetOf(drawing, "Noise")).toMatchObject({ kind: "value", live: "Noise" });
  expect(targetOf(drawing, "cooperate/members[0]")).toMatchObject({ kind: "value", title: "the wire from Noise" });
  expect(targetOf(drawing, "$result")).toMatchObject({ kind: "value", live: "." });
  expect(targetOf(drawing, "text")).toBeUndefined();
  expect(targetOf(drawing, "gone")).toBeUndefined();
});

test("states and transitions are told apart", () => {
  const drawing = create(DrawingSchema, {
    kind: Drawing_Kind.STATES,
    states: [{ name: "Searching" }],
    transitions: [{ from: "Searching", index: 1, to: "Acquiring" }],
  });
  expect(targetOf(drawing, "Searching/1")).toEqual({ kind: "transition", from: "Searching", to: "Acquiring" });
  expect(targetOf(drawing, "Searching")).toEqual({ kind: "state", name: "Searching" });
});

test("a node's parameters stand directly below it", () => {
  const ports = ["gain", "a.Noise.persistence", "a.Noise.inner.gain", "a.Noise2.x", "a.Noise"].map((path) => ({
    path,
  }));
  expect(parametersBelow(ports, "a.Noise").map(({ path }) => path)).toEqual(["a.Noise.persistence"]);
  expect(parametersBelow(ports, "").map(({ path }) => path)).toEqual(["gain"]);
});

test("parameters are called as people call them", () => {
  expect(parameterName("movement.Probe.safety_margin")).toBe("safety margin");
  expect(parameterName("movement.gains[0]")).toBe("weight 1");
});

test("a value that stands in the text is known there, in the unit of the text", () => {
  const node = {
    inputs: [
      { name: "safety_margin", value: "0.4 m" },
      { name: "goal", value: "" },
    ],
  };
  expect(isWritten(node, "safety margin", "0.4", "m")).toBe(true);
  expect(isWritten(node, "safety margin", "0.5", "m")).toBe(false);
  expect(isWritten({ inputs: [{ name: "range", value: "1 km" }] }, "range", "1", "m")).toBe(false);
  expect(isWritten({ inputs: [{ name: "range", value: "1e3" }] }, "range", "1000", "m")).toBe(true);
  expect(isWritten(node, "goal", "true", "")).toBe(false);
  expect(isWritten(undefined, "goal", "1", "")).toBe(false);
});
