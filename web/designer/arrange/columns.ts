// A layout for pages that are too large for elk: what drives stands in a column left of what it drives, above each other
// in the order of the readers. What would be too tall is folded into bands beside each other. Linear in nodes and wires.
import { onPitch, type Spot } from "./elk.ts";
import type { LayoutGraph, LayoutNode } from "./graph.ts";

const kBetweenColumns = 96; // [px]
const kBetweenBands = 160;
const kBetweenNodes = 32;
const kShape = 1.6; // of the page: its width by its height, as windows are
const kFew = 8; // columns of so few nodes stand as they are; the first of more is folded, with all that drives it

/** Nodes by columns, the first at the right. */
type Columns = LayoutNode[][];

export function columnSpots(graph: LayoutGraph): Spot[] {
  const ordered = fromReaders(graph);
  const counts: number[] = [];
  for (const { column } of ordered) counts[column] = (counts[column] ?? 0) + 1;
  const cut = Math.max(
    0,
    counts.findIndex((count) => count > kFew),
  );
  const ends: Columns = [];
  const units: Columns[] = [];
  for (const { node, column } of ordered) {
    if (column < cut) add(ends, column, node);
    else {
      if (column === cut) units.push([]);
      add(units.at(-1)!, column - cut, node);
    }
  }
  const all = join(units);
  const bands = folded(units, Math.sqrt((heightOf(all) * (widthOf(all) + kBetweenBands)) / kShape));
  const spots: Spot[] = [];
  let right = place(ends, 0, spots);
  for (const band of bands.toReversed()) right = place(band, right, spots) - (kBetweenBands - kBetweenColumns);
  return spots;
}

/** Every node once, each reader before what drives it; its column is how far it is from the end. */
function fromReaders(graph: LayoutGraph): { node: LayoutNode; column: number }[] {
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
  const ordered: { node: LayoutNode; column: number }[] = [];
  const seen = new Set<string>();
  const visit = (begin: LayoutNode) => {
    const waiting = [{ node: begin, column: 0 }];
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      const { node, column } = next;
      if (seen.has(node.id)) continue;
      seen.add(node.id);
      ordered.push(next);
      for (const id of (drivers.get(node.id) ?? []).toReversed())
        waiting.push({ node: byId.get(id)!, column: column + 1 });
    }
  };
  for (const node of graph.nodes) if (!isDriver.has(node.id)) visit(node);
  for (const node of graph.nodes) visit(node); // what is left drives itself in a circle
  return ordered;
}

function add(columns: Columns, column: number, node: LayoutNode): void {
  columns[column] ??= [];
  columns[column].push(node);
}

function addAll(columns: Columns, unit: Columns): void {
  for (const [column, nodes] of unit.entries()) for (const node of nodes) add(columns, column, node);
}

function join(units: readonly Columns[]): Columns {
  const columns: Columns = [];
  for (const unit of units) addAll(columns, unit);
  return columns;
}

/** Units in their order, in bands of about this height [px]; a unit stays whole. */
function folded(units: readonly Columns[], height: number): Columns[] {
  const bands: Columns[] = [];
  let taken: number[] = []; // of the last band, by column
  for (const unit of units) {
    const added = unit.map(columnHeight);
    const isFull = added.some((more, column) => (taken[column] ?? 0) > 0 && taken[column]! + more > height);
    if (isFull || bands.length === 0) {
      bands.push([]);
      taken = [];
    }
    addAll(bands.at(-1)!, unit);
    for (const [column, more] of added.entries()) taken[column] = (taken[column] ?? 0) + more;
  }
  return bands;
}

function columnHeight(nodes: readonly LayoutNode[]): number {
  return nodes.reduce((sum, node) => sum + node.height + kBetweenNodes, 0);
}

function heightOf(columns: Columns): number {
  return Math.max(0, ...columns.map(columnHeight));
}

function columnWidth(nodes: readonly LayoutNode[]): number {
  return nodes.reduce((most, node) => Math.max(most, node.width), 0) + kBetweenColumns;
}

function widthOf(columns: Columns): number {
  return columns.reduce((sum, nodes) => sum + columnWidth(nodes), 0);
}

/** From the first column, whose right side is at `right`, leftwards; each in the middle of the height. Gives where it ends. */
function place(columns: Columns, right: number, spots: Spot[]): number {
  let at = right;
  for (const nodes of columns) {
    let y = -columnHeight(nodes) / 2;
    for (const node of nodes) {
      spots.push({ id: node.id, x: onPitch(at - node.width), y: onPitch(y) });
      y += node.height + kBetweenNodes;
    }
    at -= columnWidth(nodes);
  }
  return at;
}
