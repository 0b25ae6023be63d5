// Automatic layout, off the page's thread. elk is loaded with it, the first time that something is laid out.
import ELK from "elkjs/lib/elk.bundled.js";
import { fromElk, gridSpots, type Spot, toElk } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";

const elk = new ELK();

self.onmessage = async (event: MessageEvent<{ request: number; graph: LayoutGraph }>) => {
  const { request, graph } = event.data;
  let spots: Spot[];
  try {
    spots = graph.kind === "grid" ? gridSpots(graph) : fromElk(await elk.layout(toElk(graph)));
  } catch {
    spots = gridSpots(graph); // what elk can't do still has to be seen
  }
  self.postMessage({ request, spots });
};
