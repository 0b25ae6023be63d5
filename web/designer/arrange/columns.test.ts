import { expect, test } from "vitest";
import { columnSpots } from "./columns.ts";
import type { LayoutGraph } from "./graph.ts";

function many(sums: number): LayoutGraph {
  const node = (id: string) => ({ id, width: 160, height: 64, inputs: [], outputY: 20 });
  const names = [...Array(sums).keys()];
  return {
    kind: "dataflow",
    nodes: [node("all"), ...names.flatMap((i) => [node(`sum${i}`), node(`noise${i}`)])],
    wires: names.flatMap((i) => [
      { from: `sum${i}`, to: "all", port: `members[${i}]` },
      { from: `noise${i}`, to: `sum${i}`, port: "members[0]" },
    ]),
  };
}

test("what drives stands left of what it drives, and nothing on anything", () => {
  const spots = new Map(columnSpots(many(20)).map((spot) => [spot.id, spot]));
  expect(spots.size).toBe(41);
  expect(spots.get("noise3")!.x).toBeLessThan(spots.get("sum3")!.x);
  expect(spots.get("sum3")!.x).toBeLessThan(spots.get("all")!.x);
  expect(new Set([...spots.values()].map(({ x, y }) => `${x} ${y}`)).size).toBe(41);
});

test("a circle is laid out too", () => {
  const graph = many(1);
  graph.wires.push({ from: "all", to: "noise0", port: "again" });
  expect(columnSpots(graph)).toHaveLength(3);
});
