// Running and the map beside the canvas, as the designer's page has places for them.
import type { Extensions } from "../designer/session/extensions.ts";
import { liveActions } from "./panes/actions.ts";
import { LiveDetails } from "./panes/live_details.tsx";
import { LiveInputs } from "./panes/live_inputs.tsx";
import { LiveLine } from "./panes/live_line.tsx";
import { LiveSide } from "./panes/live_side.tsx";
import { liveMenu } from "./panes/menu.ts";
import { OverDrawing } from "./panes/over_drawing.tsx";
import { RunBar } from "./panes/run_bar.tsx";
import { testActions } from "./tests/actions.ts";
import { CycleBanner } from "./tests/cycle_banner.tsx";
import { TestsHeader, TestsPanel } from "./tests/tests_panel.tsx";

export const extensions: Extensions = {
  run: RunBar,
  live: LiveSide,
  details: LiveDetails,
  inputs: LiveInputs,
  menu: liveMenu,
  actions: (designer) => [...liveActions(designer), ...testActions(designer)],
  bottom: LiveLine,
  tests: { header: TestsHeader, panel: TestsPanel },
  over: [OverDrawing, CycleBanner],
};
