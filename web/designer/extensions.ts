// What stands in the page's frame without belonging to drawing: running, and the map beside the canvas.
import type { ComponentType } from "react";
import type { Action } from "./actions/action.ts";
import type { Designer } from "./designer.ts";

export interface Extensions {
  /** In the middle of the top bar: Run, Pause and the like. */
  run: ComponentType | null;
  /** The pane right of the canvas, shown while `shown.live`. */
  live: ComponentType | null;
  /** Added to the menus of a node, a wire or a transition; `id` as in `State.selection`. */
  menu: ((designer: Designer, id: string) => readonly Action[]) | null;
  /** Added to all actions, with their shortcuts. */
  actions: ((designer: Designer) => readonly Action[]) | null;
}

export const extensions: Extensions = { run: null, live: null, menu: null, actions: null };
