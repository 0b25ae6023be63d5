// Asks the worker for a layout.
import type { Drawing } from "../session/protocol.ts";
import type { Spot } from "./elk.ts";
import { graphOf } from "./graph.ts";
import { gridSpots } from "./grid.ts";

let worker: Worker | null = null;
let lastRequest = 0;
const waiting = new Map<number, (spots: Spot[]) => void>();

/** Places for everything on the page. */
export function layOut(drawing: Drawing): Promise<Spot[]> {
  const graph = graphOf(drawing);
  if (graph.kind === "grid") return Promise.resolve(gridSpots(graph));
  worker ??= start();
  const request = ++lastRequest;
  return new Promise((resolve) => {
    waiting.set(request, resolve);
    worker!.postMessage({ request, graph });
  });
}

/** While the page is on its way: its layout does not have to wait for the worker to start. */
export function prepareLayout(): void {
  worker ??= start();
}

function start(): Worker {
  const started = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  started.onmessage = (event: MessageEvent<{ request: number; spots: Spot[] }>) => {
    waiting.get(event.data.request)?.(event.data.spots);
    waiting.delete(event.data.request);
  };
  return started;
}
