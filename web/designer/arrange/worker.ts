// Automatic layout, off the page's thread. elk is large: it is loaded as soon as the worker runs, while the page is still
// on its way.
import type { ELK, ElkNode } from "elkjs/lib/elk-api";
import { columnSpots } from "./columns.ts";
import { fromElk, gridSpots, largest, type Spot, toElk } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";

const kMostForElk = 240; // nodes; its time grows faster than their number

const elk: Promise<ELK> = import("elkjs/lib/elk.bundled.js").then(({ default: Elk }) => {
  const made = new Elk();
  self.onmessage = answer; // elk takes what is said to a worker for said to itself
  return made;
});

self.onmessage = answer;

async function answer(event: MessageEvent<{ request: number; graph: LayoutGraph }>): Promise<void> {
  const { request, graph } = event.data;
  let spots: Spot[];
  try {
    const isLarge = graph.kind === "dataflow" && graph.nodes.length > kMostForElk;
    if (graph.kind === "grid") spots = gridSpots(graph);
    else if (isLarge) spots = columnSpots(graph);
    else if (graph.kind === "dataflow") spots = fromElk(await laidOut(toElk(graph)));
    else spots = fromElk(largest([await laidOut(toElk(graph)), await laidOut(toElk(graph, "DOWN"))]));
  } catch {
    spots = gridSpots(graph); // what elk can't do still has to be seen
  }
  self.postMessage({ request, spots });
}

async function laidOut(graph: ElkNode): Promise<ElkNode> {
  return (await elk).layout(graph);
}
