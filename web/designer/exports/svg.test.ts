import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Drawing_Kind, DrawingSchema } from "../protocol.ts";
import { drawingAsSvg } from "./svg.ts";

test("an exported dataflow is well formed, and has its nodes, values and wires", () => {
  const drawing = create(DrawingSchema, {
    kind: Drawing_Kind.DATAFLOW,
    nodes: [
      { name: "a", component: "a<b>&c", type: "Vector", inputs: [{ name: "persistence", value: "10 s" }] },
      { name: "b", type: "Vector", inputs: [{ name: "v", type: "Vector" }] },
    ],
    wires: [{ from: "a", to: "b", port: "v", type: "Vector" }],
    resultNode: "b",
    resultType: "Vector",
  });
  const places = new Map([
    ["a", { x: 0, y: 0 }],
    ["b", { x: 300, y: 0 }],
  ]);
  const { svg, width } = drawingAsSvg(drawing, places, "A & B");
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml");
  expect(parsed.querySelector("parsererror")).toBeNull();
  expect(svg).toContain("a&lt;b&gt;&amp;c");
  expect(svg).toContain("10 s");
  expect(svg).toContain("<title>A &amp; B</title>");
  expect(width).toBeGreaterThan(500);
});

test("exported states have their transitions", () => {
  const drawing = create(DrawingSchema, {
    kind: Drawing_Kind.STATES,
    states: [
      { name: "Searching", isStart: true, title: "Wander" },
      { name: "Resting", isFinal: true },
    ],
    transitions: [{ from: "Searching", to: "Resting", trigger: "IsHalted()" }],
  });
  const places = new Map([
    ["Searching", { x: 0, y: 0 }],
    ["Resting", { x: 400, y: 100 }],
  ]);
  const { svg } = drawingAsSvg(drawing, places, "Forage");
  expect(svg).toContain("IsHalted()");
  expect(svg).toContain("Searching");
  expect(svg).not.toContain("NaN");
});
