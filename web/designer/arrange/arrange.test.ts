import { create } from "@bufbuild/protobuf";
import ELK from "elkjs/lib/elk.bundled.js";
import { expect, test } from "vitest";
import { DrawingSchema } from "../session/protocol.ts";
import { alignedBoxes, arrangeChange } from "./arrange.ts";
import { fromElk, toElk } from "./elk.ts";
import { graphOf } from "./graph.ts";

const box = (id: string, x: number, y: number, width = 100) => ({ id, position: { x, y }, width, height: 40 });

test("boxes are brought in line", () => {
  const boxes = [box("a", 0, 0), box("b", 56, 80, 200)];
  expect(alignedBoxes(boxes, "left").map((one) => one.position.x)).toEqual([0, 0]);
  expect(alignedBoxes(boxes, "right").map((one) => one.position.x)).toEqual([160, 56]);
  expect(alignedBoxes(boxes, "top").map((one) => one.position.y)).toEqual([0, 0]);
  expect(alignedBoxes([box("a", 0, 0)], "left")).toEqual([]);
});

test("boxes are spread with the same room between them", () => {
  const spread = alignedBoxes([box("a", 0, 0), box("b", 110, 0), box("c", 400, 0)], "across");
  expect(spread.map((one) => one.position.x)).toEqual([0, 200, 400]);
});

const drawing = create(DrawingSchema, {
  page: { path: "A" },
  resultNode: "b",
  resultType: "Vector",
  nodes: [
    { name: "a", type: "Vector" },
    { name: "b", type: "Vector", inputs: [{ name: "v", type: "Vector" }] },
  ],
  wires: [{ from: "a", to: "b", port: "v", type: "Vector" }],
  notes: [{ id: "1", text: "why", x: 0, y: 0, width: 100, height: 50 }],
});

test("the first move writes down where everything stands, later ones only what moved", () => {
  const places = new Map([
    ["a", { x: 0, y: 0 }],
    ["b", { x: 200, y: 0 }],
  ]);
  const moved = [{ id: "a", position: { x: 13, y: 3 } }];
  const nodes = (isArranged: boolean) => {
    const [change] = arrangeChange(drawing, moved, places, isArranged).changes;
    return change?.case === "arrange" ? change.value.nodes : [];
  };
  expect(nodes(false)).toEqual([
    { node: "a", x: 16, y: 0 },
    { node: "b", x: 200, y: 0 },
  ]);
  expect(nodes(true)).toEqual([{ node: "a", x: 16, y: 0 }]);
});

test("a comment is moved by a change of its own", () => {
  const { changes } = arrangeChange(drawing, [{ id: "1", position: { x: 40, y: 8 } }], new Map(), true);
  expect(changes).toMatchObject([{ case: "setNote", value: { id: "1", text: "why", x: 40, y: 8, width: 100 } }]);
});

test("what drives stands left of what is driven, and the result at the right", async () => {
  const spots = fromElk(await new ELK().layout(toElk(graphOf(drawing))));
  const x = Object.fromEntries(spots.map((spot) => [spot.id, spot.x]));
  expect(x.a).toBeLessThan(x.b!);
  expect(x.b).toBeLessThan(x.$result!);
});

test("a wire of something that has no output does not keep the rest from its place", async () => {
  const graph = graphOf(drawing);
  const dumb = { id: "unknown", width: 120, height: 40, inputs: [], outputY: -1 };
  const wires = [...graph.wires, { from: "unknown", to: "b", port: "nowhere" }];
  const result = await new ELK().layout(toElk({ ...graph, nodes: [...graph.nodes, dumb], wires }));
  expect(fromElk(result)).toHaveLength(graph.nodes.length + 1);
});
