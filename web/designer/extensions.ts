// What stands in the page's frame without belonging to drawing: running, and the map beside the canvas.
import type { ComponentType } from "react";
import type { Action } from "./actions/action.ts";
import type { Designer } from "./designer.ts";
import { liveActions } from "./live/actions.ts";
import { LiveDetails } from "./live/live_details.tsx";
import { LiveInputs } from "./live/live_inputs.tsx";
import { LiveSide } from "./live/live_side.tsx";
import { liveMenu } from "./live/menu.ts";
import { RunBar } from "./live/run_bar.tsx";
import type { Drawing } from "./protocol.ts";

export interface Extensions {
  /** In the middle of the top bar: Run, Pause and the like. */
  run: ComponentType | null;
  /** The pane right of the canvas, shown while `shown.live`. */
  live: ComponentType | null;
  /** At the end of the details of what is selected; `id` as in `State.selection`. */
  details: ComponentType<{ drawing: Drawing; id: string }> | null;
  /** Gives the fields of a node's inputs while it runs. */
  inputs: typeof LiveInputs | null;
  /** Added to the menus of a node, a wire or a transition. */
  menu: ((designer: Designer, id: string) => readonly Action[]) | null;
  /** Added to all actions, with their shortcuts. */
  actions: ((designer: Designer) => readonly Action[]) | null;
}

export const extensions: Extensions = {
  run: RunBar,
  live: LiveSide,
  details: LiveDetails,
  inputs: LiveInputs,
  menu: liveMenu,
  actions: liveActions,
};
