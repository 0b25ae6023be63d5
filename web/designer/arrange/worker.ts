// Automatic layout, off the page's thread. elk is large: it is loaded as soon as the worker runs, while the page is still
// on its way.
import type { ELK } from "elkjs/lib/elk-api";
import { columnSpots } from "./columns.ts";
import { methodFor } from "./effort.ts";
import { fromElk, type Spot, toElk } from "./elk.ts";
import type { LayoutGraph } from "./graph.ts";
import { flowSpots, gridSpots, mostReadable, snakeSpots } from "./grid.ts";

const elk: Promise<ELK> = import("elkjs/lib/elk.bundled.js").then(({ default: Elk }) => {
  const made = new Elk();
  self.onmessage = answer; // elk takes what is said to a worker for said to itself
  return made;
});

self.onmessage = answer;

async function answer(event: MessageEvent<{ request: number; graph: LayoutGraph }>): Promise<void> {
  const { request, graph } = event.data;
  const spots = await laidOut(graph).catch(() => gridSpots(graph)); // what elk can't do still has to be seen
  self.postMessage({ request, spots });
}

async function laidOut(graph: LayoutGraph): Promise<Spot[]> {
  const method = methodFor(graph);
  if (method === "grid") return gridSpots(graph);
  if (method === "columns") return columnSpots(graph);
  if (method === "snake") return snakeSpots(graph);
  const engine = await elk;
  const across = fromElk(await engine.layout(toElk(graph, method)));
  if (graph.kind === "dataflow") return flowSpots(across, graph);
  return mostReadable([across, fromElk(await engine.layout(toElk(graph, method, "DOWN")))], graph);
}
