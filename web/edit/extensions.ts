// Running and the map beside the canvas, as the designer's page has places for them.
import type { Extensions } from "../designer/session/extensions.ts";
import { liveActions } from "./panes/actions.ts";
import { LiveDetails } from "./panes/live_details.tsx";
import { LiveInputs } from "./panes/live_inputs.tsx";
import { LiveSide } from "./panes/live_side.tsx";
import { liveMenu } from "./panes/menu.ts";
import { RunBar } from "./panes/run_bar.tsx";

export const extensions: Extensions = {
  run: RunBar,
  live: LiveSide,
  details: LiveDetails,
  inputs: LiveInputs,
  menu: liveMenu,
  actions: liveActions,
};
