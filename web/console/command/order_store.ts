// The command that is being made on the map: the goal by mouse, the rest in the window beside it.

import { createStore } from "zustand/vanilla";
import type { Point } from "../../core/geometry.ts";
import type { FormationName, TaskName, TechniqueName } from "../../core/mdl_text.ts";

export interface Goal {
  readonly at: Point;
  /** Index of the control measure that it snapped to. */
  readonly measure: number | null;
  /** Index of a line at the place, which could be followed. */
  readonly line: number | null;
}

export interface MapOrder {
  readonly goal: Goal | null;
  readonly isDragging: boolean;
  readonly heading: number | null;
  readonly task: TaskName;
  readonly formation: FormationName | "";
  readonly technique: TechniqueName | "";
  /** [m/s]; 0: the robots' own. */
  readonly speed: number;
}

export const orderStore = createStore<MapOrder>(() => ({
  goal: null,
  isDragging: false,
  heading: null,
  task: "MOVETO",
  formation: "",
  technique: "",
  speed: 0,
}));

export const dropGoal = (): void => orderStore.setState({ goal: null, heading: null, isDragging: false });
