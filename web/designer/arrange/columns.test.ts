import { expect, test } from "vitest";
import { columnSpots } from "./columns.ts";
import type { LayoutGraph } from "./graph.ts";
import { flowSpots } from "./grid.ts";
import { zoomOf } from "./sight.ts";

function many(sums: number): LayoutGraph {
  const node = (id: string) => ({ id, width: 160, height: 64, inputs: [], outputY: 20 });
  const names = [...Array(sums).keys()];
  return {
    kind: "dataflow",
    nodes: [node("result"), node("all"), ...names.flatMap((i) => [node(`sum${i}`), node(`noise${i}`)])],
    wires: [
      { from: "all", to: "result", port: "value" },
      ...names.flatMap((i) => [
        { from: `sum${i}`, to: "all", port: `members[${i}]` },
        { from: `noise${i}`, to: `sum${i}`, port: "members[0]" },
      ]),
    ],
  };
}

test("what drives stands left of what it drives, and nothing on anything", () => {
  const spots = new Map(columnSpots(many(20)).map((spot) => [spot.id, spot]));
  expect(spots.size).toBe(42);
  expect(spots.get("noise3")!.x).toBeLessThan(spots.get("sum3")!.x);
  expect(spots.get("sum3")!.x).toBeLessThan(spots.get("all")!.x);
  expect(new Set([...spots.values()].map(({ x, y }) => `${x} ${y}`)).size).toBe(42);
});

const bounds = (graph: LayoutGraph) => {
  const spots = columnSpots(graph);
  const [xs, ys] = [spots.map(({ x }) => x), spots.map(({ y }) => y)];
  return {
    width: Math.max(...xs) + 160 - Math.min(...xs),
    height: Math.max(...ys) + 64 - Math.min(...ys),
  };
};

test.each([150, 1000, 3000])("a page of %i sums is about as wide as a window is, not one tall strip", (sums) => {
  const { width, height } = bounds(many(sums));
  expect(width / height).toBeGreaterThan(1);
  expect(width / height).toBeLessThan(2.6);
});

test("what is folded lies on nothing, and stays left of what it drives", () => {
  const graph = many(400);
  const spots = columnSpots(graph);
  const at = new Map(spots.map((spot) => [spot.id, spot]));
  expect(at.size).toBe(graph.nodes.length);
  for (const { from, to } of graph.wires) expect(at.get(from)!.x).toBeLessThan(at.get(to)!.x);
  const sorted = spots.toSorted((a, b) => a.x - b.x);
  sorted.forEach((a, i) => {
    for (let j = i + 1; j < sorted.length && sorted[j]!.x < a.x + 160; ++j)
      expect(Math.abs(sorted[j]!.y - a.y)).toBeGreaterThanOrEqual(64);
  });
});

test("many that drive nothing are folded as well", () => {
  const graph = many(600);
  graph.nodes.splice(0, 2);
  graph.wires = graph.wires.filter(({ to }) => to.startsWith("sum"));
  const { width, height } = bounds(graph);
  expect(width / height).toBeGreaterThan(1);
  expect(width / height).toBeLessThan(2.6);
});

test.each([12, 30, 100])("what drives a sum of %i stands in columns where one would be a strip", (members) => {
  const names = [...Array(members).keys()].map((i) => `noise${i}`);
  const graph: LayoutGraph = {
    kind: "dataflow",
    nodes: [
      { id: "sum", width: 208, height: 46 + 24 * members, inputs: [], outputY: 20 },
      ...names.map((id) => ({ id, width: 160, height: 70, inputs: [], outputY: 20 })),
    ],
    wires: names.map((from, i) => ({ from, to: "sum", port: `members[${i}]` })),
  };
  const strip = graph.nodes.map(({ id }, i) => ({ id, x: id === "sum" ? 300 : 0, y: id === "sum" ? 0 : 102 * i }));
  const spots = flowSpots(strip, graph);
  const columns = new Set(spots.map(({ x }) => x)).size - 1;
  expect(columns).toBe(members === 12 ? 1 : members === 30 ? 4 : 5); // twelve can be read in one
  expect(zoomOf(spots, graph)).toBeGreaterThan(0.3);
  expect(spots.find(({ id }) => id === "sum")!.x).toBe(Math.max(...spots.map(({ x }) => x)));
});

test("a circle is laid out too", () => {
  const graph = many(1);
  graph.wires.push({ from: "all", to: "noise0", port: "again" });
  expect(columnSpots(graph)).toHaveLength(4);
});
