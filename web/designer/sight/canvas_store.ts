// What the canvas knows from one moment to the next: how far away it is looked at from, which inputs a wire that is being
// drawn may lead to, which value is edited.
import { createStore, useStore } from "zustand";

export type Distance = "near" | "far" | "farthest";

export interface CanvasState {
  distance: Distance;
  /** How much larger than usual names and labels of states are written, as scaleAt says. */
  scale: number;
  /** While a wire is drawn: for every input (`node/port`) or, drawn backwards, node, why it does not fit; empty: it does. */
  fits: ReadonlyMap<string, string> | null;
  /** The input whose value is edited. */
  editing: { node: string; row: string; what: "value" | "weight" } | null;
  /** The comment or frame that has just been made: its words are typed at once. */
  writing: string;
  /** The component that is dragged out of the palette; empty: none. */
  dragged: string;
  /** The transition that a dragged trigger would be dropped on. */
  aimedAt: string;
  /** What of the page was found by its words. */
  found: ReadonlySet<string>;
  /** Where the pointer last was on the canvas, in its coordinates. */
  pointer: { x: number; y: number };
  /** Grows whenever something has another place than the drawing says. */
  moves: number;
  /** In its coordinates: what of it is in sight. */
  view: { x: number; y: number; width: number; height: number };
}

export const canvasStore = createStore<CanvasState>(() => ({
  distance: "near",
  scale: 1,
  fits: null,
  editing: null,
  writing: "",
  dragged: "",
  aimedAt: "",
  found: new Set(),
  pointer: { x: 0, y: 0 },
  moves: 0,
  view: { x: 0, y: 0, width: 800, height: 600 },
}));

export function useCanvas<T>(pick: (state: CanvasState) => T): T {
  return useStore(canvasStore, pick);
}

const kCrowd = 300; // nodes

/** Inner parts of nodes are left out where they could not be read. */
export function distanceAt(zoom: number, nodes: number): Distance {
  const isCrowd = nodes > kCrowd;
  if (zoom < (isCrowd ? 0.2 : 0.12)) return "farthest";
  return zoom < (isCrowd ? 0.5 : 0.35) ? "far" : "near";
}
