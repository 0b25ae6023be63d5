// How the map is being edited: shared by the tools on the map and the panels beside it.
import { createStore } from "zustand/vanilla";
import type { MeasureKind } from "../../core/measure_kinds.ts";
import type { ObjectStyle } from "./things.ts";

export interface EditSettings {
  /** Points snap to a grid that fits the zoom. */
  readonly grid: boolean;
  /** What a click of the world tool does. */
  readonly world: "change" | "obstacle" | "object";
  /** Of what is added by a click [m]; 0: what fits the area. */
  readonly radius: number;
  readonly style: ObjectStyle;
  readonly color: string;
  /** What the drawing tool draws; null: it changes what stands. */
  readonly kind: MeasureKind | null;
  /** The overlay that new things go to; empty: the first. */
  readonly document: string;
}

export const editStore = createStore<EditSettings>(() => ({
  grid: true,
  world: "change",
  radius: 0,
  style: "movable",
  color: "orange",
  kind: null,
  document: "",
}));

export const changeEditing = (change: Partial<EditSettings>): void => editStore.setState(change);
