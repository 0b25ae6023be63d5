// What is being drawn, shared by the tool on the map and the panel beside it.
import { createStore } from "zustand/vanilla";
import type { Draft } from "./draft.ts";

export interface Drawing {
  readonly draft: Draft | null;
  /** Index of the measure that was just drawn and wants a name; -1: none. */
  readonly naming: number;
}

export const drawingStore = createStore<Drawing>(() => ({ draft: null, naming: -1 }));
