// Automatic layout, off the page's thread. elk is loaded with it, the first time that something is laid out.
import ELK from "elkjs/lib/elk.bundled.js";
import { columnSpots } from "./columns.ts";
import { fromElk, gridSpots, largest, type Spot, toElk } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";

const elk = new ELK();
const kMostForElk = 240; // nodes; its time grows faster than their number

self.onmessage = async (event: MessageEvent<{ request: number; graph: LayoutGraph }>) => {
  const { request, graph } = event.data;
  let spots: Spot[];
  try {
    const isLarge = graph.kind === "dataflow" && graph.nodes.length > kMostForElk;
    if (graph.kind === "grid") spots = gridSpots(graph);
    else if (isLarge) spots = columnSpots(graph);
    else if (graph.kind === "dataflow") spots = fromElk(await elk.layout(toElk(graph)));
    else spots = fromElk(largest([await elk.layout(toElk(graph)), await elk.layout(toElk(graph, "DOWN"))]));
  } catch {
    spots = gridSpots(graph); // what elk can't do still has to be seen
  }
  self.postMessage({ request, spots });
};
