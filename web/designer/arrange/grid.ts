// Rows: for what has no wires, and for states of which a layered layout would be too large to read.
import { columnSpots } from "./columns.ts";
import { onPitch, type Spot } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";
import { zoomOf } from "./sight.ts";

const kLegible = 0.3; // zoom; below it letters are of 4 px
const kClear = 0.5; // zoom; values of nodes are still to be made out
const kLarger = 1.3; // what wires that pass behind nodes are worth

/** Things that have no wires: four in a row, each column as wide as the widest. */
export function gridSpots(graph: LayoutGraph): Spot[] {
  return rowsOf(graph, 4, 40);
}

/** States in the order of the text, to the right and back again, with room for what is written at transitions. */
export function snakeSpots(graph: LayoutGraph): Spot[] {
  return rowsOf(graph, Math.ceil(Math.sqrt(graph.nodes.length)), 120, true);
}

/** Of several layouts the one that is seen largest, or the snake where none of them could be read. */
export function mostReadable(layouts: readonly Spot[][], graph: LayoutGraph): Spot[] {
  const zooms = layouts.map((spots) => zoomOf(spots, graph));
  const best = Math.max(...zooms);
  return best < kLegible ? snakeSpots(graph) : layouts[zooms.indexOf(best)]!;
}

/** Dataflow as elk lays it out, or in columns where that is a strip, and columns are seen clearly larger. */
export function flowSpots(across: Spot[], graph: LayoutGraph): Spot[] {
  const zoom = zoomOf(across, graph);
  if (zoom >= kClear) return across;
  const columns = columnSpots(graph);
  return zoomOf(columns, graph) > kLarger * zoom ? columns : across;
}

/** `room`: between them [px]; `isSnake`: every second row goes back. */
function rowsOf({ nodes }: LayoutGraph, columns: number, room: number, isSnake = false): Spot[] {
  const width = nodes.reduce((most, node) => Math.max(most, node.width), 160) + room;
  const spots: Spot[] = [];
  let y = 0;
  for (let begin = 0; begin < nodes.length; begin += columns) {
    const row = nodes.slice(begin, begin + columns);
    const isBack = isSnake && (begin / columns) % 2 === 1;
    for (const [i, node] of row.entries())
      spots.push({ id: node.id, x: onPitch((isBack ? columns - 1 - i : i) * width), y: onPitch(y) });
    y += Math.max(...row.map((node) => node.height)) + room;
  }
  return spots;
}
