// The command that is being made on the map: the goal by mouse, the rest in the window beside it.

import { createStore } from "zustand/vanilla";
import type { Point } from "../../core/geometry.ts";
import { type FormationName, type TaskName, type TechniqueName, taskInfo } from "../../core/mdl_text.ts";

export interface Goal {
  readonly at: Point;
  /** Index of the control measure that it snapped to. */
  readonly measure: number | null;
  /** Index of a line at the place, which could be followed. */
  readonly line: number | null;
}

export interface MapOrder {
  readonly goal: Goal | null;
  /** Where the task takes several places: those behind the goal, in the order of the clicks. */
  readonly more: readonly Goal[];
  readonly isDragging: boolean;
  readonly heading: number | null;
  readonly task: TaskName;
  readonly formation: FormationName | "";
  readonly technique: TechniqueName | "";
  /** [m/s]; 0: the robots' own. */
  readonly speed: number;
  /** [m]; 0: the usual one. */
  readonly swath: number;
}

export const orderStore = createStore<MapOrder>(() => ({
  goal: null,
  more: [],
  isDragging: false,
  heading: null,
  task: "MOVETO",
  formation: "",
  technique: "",
  speed: 0,
  swath: 0,
}));

export const dropGoal = (): void => orderStore.setState({ goal: null, more: [], heading: null, isDragging: false });

/** Whether a click adds a place, instead of being another goal. */
export const takesMorePlaces = ({ goal, task }: MapOrder): boolean =>
  goal !== null && taskInfo(task).place === "places";
