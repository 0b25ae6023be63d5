// A layout for pages that are too large for elk, or of which elk makes a tall strip: what drives a node stands left of it, in
// as many columns as let the page be seen largest; all that drives one of these stands left of that, in the same way.
// Linear in nodes and wires, but for how many columns are tried.
import { onPitch, type Spot } from "./elk.ts";
import type { LayoutGraph, LayoutNode } from "./graph.ts";
import { kUsualView } from "./sight.ts";

const kBetweenColumns = 72; // [px]
const kBetweenNodes = 28;
const kMostColumns = 60;

interface Size {
  width: number;
  height: number;
}

/** A node with all that drives it. */
interface Unit {
  readonly node: LayoutNode;
  readonly drivers: Unit[];
  /** Of all of it [px]. */
  size: Size;
  columns: Unit[][];
}

export function columnSpots(graph: LayoutGraph): Spot[] {
  const { ends, all } = unitsOf(graph);
  for (const unit of all.toReversed()) {
    unit.columns = folded(unit.drivers, unit.node);
    unit.size = sizeWith(unit.columns, unit.node);
  }
  const spots: Spot[] = [];
  const waiting: { unit: Unit; right: number; top: number }[] = [];
  const place = (columns: Unit[][], right: number, top: number, height: number) => {
    let at = right;
    for (const column of columns) {
      let y = top + (height - heightOf(column)) / 2;
      for (const unit of column) {
        waiting.push({ unit, right: at, top: y });
        y += unit.size.height + kBetweenNodes;
      }
      at -= widthOf(column) + kBetweenColumns;
    }
  };
  place(folded(ends, null), 0, 0, 0);
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const { unit, right, top } = next;
    const { node, size, columns } = unit;
    spots.push({ id: node.id, x: onPitch(right - node.width), y: onPitch(top + (size.height - node.height) / 2) });
    place(columns, right - node.width - kBetweenColumns, top, size.height);
  }
  return spots;
}

/** Every node once, each reader before what drives it; `ends` drive nothing that is not in them. */
function unitsOf(graph: LayoutGraph): { ends: Unit[]; all: Unit[] } {
  const byId = new Map(graph.nodes.map((node) => [node.id, node]));
  const drivers = new Map<string, string[]>();
  const isDriver = new Set<string>();
  for (const { from, to } of graph.wires) {
    if (from === to || !byId.has(from) || !byId.has(to)) continue;
    const before = drivers.get(to);
    if (before) before.push(from);
    else drivers.set(to, [from]);
    isDriver.add(from);
  }
  const ends: Unit[] = [];
  const all: Unit[] = [];
  const seen = new Set<string>();
  const visit = (begin: LayoutNode) => {
    const waiting: { node: LayoutNode; siblings: Unit[] }[] = [{ node: begin, siblings: ends }];
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      const { node, siblings } = next;
      if (seen.has(node.id)) continue;
      seen.add(node.id);
      const unit: Unit = { node, drivers: [], size: { width: 0, height: 0 }, columns: [] };
      all.push(unit);
      siblings.push(unit);
      for (const id of (drivers.get(node.id) ?? []).toReversed())
        waiting.push({ node: byId.get(id)!, siblings: unit.drivers });
    }
  };
  for (const node of graph.nodes) if (!isDriver.has(node.id)) visit(node);
  for (const node of graph.nodes) visit(node); // what is left drives itself in a circle
  return { ends, all };
}

/**
 * Units in columns, from the last at the right to the first at the left; of all numbers of columns the one that is seen
 * largest together with the node that they drive.
 */
function folded(units: readonly Unit[], reader: LayoutNode | null): Unit[][] {
  let best: Unit[][] = [];
  let largest = 0;
  for (let count = 1; count <= Math.min(units.length, kMostColumns); ++count) {
    const columns = inColumns(units, count);
    const { width, height } = sizeWith(columns, reader);
    const zoom = Math.min(kUsualView.width / width, kUsualView.height / height);
    if (zoom > largest) {
      largest = zoom;
      best = columns;
    } else if (kUsualView.width / width < largest) break; // it only becomes wider
  }
  return best.toReversed();
}

/** Each below the shortest column: as they are read, row by row, so that a wire leads to an input at about its own height. */
function inColumns(units: readonly Unit[], count: number): Unit[][] {
  const columns: Unit[][] = Array.from({ length: count }, () => []);
  const heights = columns.map(() => 0);
  for (const unit of units) {
    const shortest = heights.indexOf(Math.min(...heights));
    columns[shortest]!.push(unit);
    heights[shortest]! += unit.size.height + kBetweenNodes;
  }
  return columns;
}

function heightOf(units: readonly Unit[]): number {
  return units.reduce((sum, { size }) => sum + size.height + kBetweenNodes, 0);
}

function widthOf(column: readonly Unit[]): number {
  return column.reduce((most, { size }) => Math.max(most, size.width), 0);
}

function sizeWith(columns: readonly Unit[][], reader: LayoutNode | null): Size {
  return {
    width: columns.reduce((sum, column) => sum + widthOf(column) + kBetweenColumns, reader?.width ?? 0),
    height: Math.max(reader?.height ?? 0, ...columns.map(heightOf)),
  };
}
