// A layout for pages that are too large for elk: what drives stands in the column left of what it drives, above each other
// in the order of the readers. Linear in nodes and wires.
import { onPitch, type Spot } from "./elk.ts";
import type { LayoutGraph, LayoutNode } from "./graph.ts";

const kBetweenColumns = 96; // [px]
const kBetweenNodes = 32;

export function columnSpots(graph: LayoutGraph): Spot[] {
  const byId = new Map(graph.nodes.map((node) => [node.id, node]));
  const drivers = new Map<string, string[]>();
  const isDriver = new Set<string>();
  for (const { from, to } of graph.wires) {
    if (from === to || !byId.has(from) || !byId.has(to)) continue;
    drivers.set(to, [...(drivers.get(to) ?? []), from]);
    isDriver.add(from);
  }
  const columns: LayoutNode[][] = [];
  const seen = new Set<string>();
  const visit = (begin: LayoutNode) => {
    const waiting = [{ node: begin, column: 0 }];
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      const { node, column } = next;
      if (seen.has(node.id)) continue;
      seen.add(node.id);
      columns[column] ??= [];
      columns[column].push(node);
      for (const id of (drivers.get(node.id) ?? []).toReversed())
        waiting.push({ node: byId.get(id)!, column: column + 1 });
    }
  };
  for (const node of graph.nodes) if (!isDriver.has(node.id)) visit(node);
  for (const node of graph.nodes) visit(node); // what is left drives itself in a circle
  return placed(columns);
}

/** From the last column, at the right, leftwards; each in the middle of the height. */
function placed(columns: LayoutNode[][]): Spot[] {
  const spots: Spot[] = [];
  let right = 0;
  for (const nodes of columns) {
    let y = -nodes.reduce((sum, node) => sum + node.height + kBetweenNodes, 0) / 2;
    for (const node of nodes) {
      spots.push({ id: node.id, x: onPitch(right - node.width), y: onPitch(y) });
      y += node.height + kBetweenNodes;
    }
    right -= Math.max(...nodes.map((node) => node.width)) + kBetweenColumns;
  }
  return spots;
}
