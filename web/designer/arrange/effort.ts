// Which layout a page gets: the more its wires span, the simpler, so that no page waits long for its places.
import type { LayoutGraph } from "./graph.ts";

/**
 * `careful`: elk with network simplex, which makes the straightest wires, and whose time grows faster than the square of the
 * effort; `quick`: elk with Brandes and Koepf's placement; the others are our own, and linear.
 */
export type Method = "careful" | "quick" | "columns" | "snake" | "grid";

// By bench/designer_layout.mjs: below these no layout took more than about a second. Labels of transitions take room of
// their own, and states are laid out twice.
const kMost = { dataflow: { careful: 500, quick: 1600 }, states: { careful: 150, quick: 2000 } };
const kMostDataflowNodes = 240; // elk's time grows with nodes that stand above each other as well

export function methodFor(graph: LayoutGraph): Method {
  if (graph.kind === "grid") return "grid";
  const effort = effortOf(graph);
  const most = kMost[graph.kind];
  const isMany = graph.kind === "dataflow" && graph.nodes.length > kMostDataflowNodes;
  if (!isMany && effort <= most.careful) return "careful";
  if (!isMany && effort <= most.quick) return "quick";
  return graph.kind === "dataflow" ? "columns" : "snake";
}

/** Nodes, and how many layers all wires span: a layered layout puts something into each of them for each wire. */
export function effortOf({ nodes, wires }: LayoutGraph): number {
  const index = new Map(nodes.map((node, i) => [node.id, i]));
  const next: number[][] = nodes.map(() => []);
  for (const { from, to } of wires) {
    const [a, b] = [index.get(from), index.get(to)];
    if (a !== undefined && b !== undefined && a !== b) next[a]!.push(b);
  }
  const { order, isBack } = walked(next);
  const layers: number[] = nodes.map(() => 0);
  for (const node of order)
    for (const to of next[node]!) if (!isBack(node, to)) layers[to] = Math.max(layers[to]!, layers[node]! + 1);
  let span = 0;
  next.forEach((ends, node) => {
    for (const to of ends) span += Math.abs(layers[to]! - layers[node]!);
  });
  return nodes.length + span;
}

/** Every node before those it leads to, but by the ways back, which close circles. */
function walked(next: readonly (readonly number[])[]) {
  const order: number[] = [];
  const place = next.map(() => 0); // in `order`, counted from its end; 0: not yet there
  const isSeen = next.map(() => false);
  for (const begin of next.keys()) {
    if (isSeen[begin]) continue;
    isSeen[begin] = true;
    const path = [{ node: begin, done: 0 }];
    for (let top = path.at(-1); top; top = path.at(-1)) {
      const to = next[top.node]![top.done++];
      if (to === undefined) {
        order.push(top.node);
        place[top.node] = order.length;
        path.pop();
      } else if (!isSeen[to]) {
        isSeen[to] = true;
        path.push({ node: to, done: 0 });
      }
    }
  }
  return { order: order.reverse(), isBack: (from: number, to: number) => place[to]! > place[from]! };
}
