import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Drawing_Kind, DrawingSchema } from "../session/protocol.ts";
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

test("a way that bows out of the states is whole in the exported picture", () => {
  const drawing = create(DrawingSchema, {
    kind: Drawing_Kind.STATES,
    states: [{ name: "A", isStart: true }, { name: "B" }, { name: "C" }],
    transitions: [
      { from: "A", to: "B", trigger: "x" },
      { from: "B", to: "C", trigger: "x" },
      { from: "C", to: "A", trigger: "x" },
    ],
  });
  const places = new Map([
    ["A", { x: 0, y: 0 }],
    ["B", { x: 0, y: 300 }],
    ["C", { x: 0, y: 600 }],
  ]);
  const { svg, width } = drawingAsSvg(drawing, places, "Round");
  const shift = Number(/<g transform="translate\((-?[\d.]+) /.exec(svg)![1]);
  for (const x of curvePoints(svg)) {
    expect(x + shift).toBeGreaterThan(0);
    expect(x + shift).toBeLessThan(width);
  }
});

/** Where each curve comes through, from left to right [px of the drawing]. */
function curvePoints(svg: string): number[] {
  const curves = [...svg.matchAll(/<path d="M(\S+) \S+ ?([CQ])([^"]+)" fill="none"/g)];
  expect(curves.length).toBe(3);
  return curves.flatMap(([, begin, , rest]) => {
    const numbers = rest!.split(/[ ,]+/).map(Number);
    const xs = [Number(begin), ...numbers.filter((_, i) => i % 2 === 0)];
    return Array.from({ length: 11 }, (_, i) => bezier(xs, i / 10));
  });
}

function bezier(xs: readonly number[], t: number): number {
  if (xs.length === 1) return xs[0]!;
  return bezier(
    xs.slice(1).map((x, i) => xs[i]! * (1 - t) + x * t),
    t,
  );
}
