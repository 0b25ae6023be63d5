// Everything that stands in the shell, in the order of its buttons.
import { lazy } from "react";
import { BreakpointsPanel, useBreakpointsBadge } from "../breakpoints/breakpoints_panel.tsx";
import { CommandTool } from "../command/command_tool.ts";
import { CommandOptions } from "../command/order_window.tsx";
import { nameActions } from "../editor/names.ts";
import { FailsafesPanel } from "../failsafes/failsafes_panel.tsx";
import { kFailsafesPlace } from "../failsafes/place.ts";
import { LogPanel } from "../log/log_panel.tsx";
import { MachinesPanel } from "../machines/machines_panel.tsx";
import { kMachinesPlace } from "../machines/place.ts";
import { useHasMachines, useMachinesBadge } from "../machines/use_machines.ts";
import { MeasureOptions, makeMeasureTool } from "../measuring/measure_tool.tsx";
import { MissionPanel } from "../mission/mission_panel.tsx";
import { DrawOptions } from "../overlay/draw_options.tsx";
import { DrawTool } from "../overlay/draw_tool.ts";
import { OverlayPanel } from "../overlay/overlay_panel.tsx";
import { kPreflightPlace } from "../preflight/place.ts";
import { PreflightPanel } from "../preflight/preflight_panel.tsx";
import { useHasVehicles, usePreflightBadge } from "../preflight/use_preflight.ts";
import { RobotsPanel } from "../robots/robots_panel.tsx";
import { SelectionPanel } from "../selection/selection_panel.tsx";
import type { ActionSource, Panel, Tool } from "../session/registry.ts";
import { ViewPanel } from "../settings/view_panel.tsx";
import { TeleoperationPanel } from "../teleoperation/teleoperation_panel.tsx";
import { useSteeredUnits } from "../teleoperation/use_reveal.ts";
import { removeActions } from "../world/remove_action.ts";
import { WorldOptions } from "../world/world_options.tsx";
import { WorldPanel } from "../world/world_panel.tsx";
import { WorldTool } from "../world/world_tool.ts";

const PlotsPanel = lazy(() => import("../plots/plots_panel.tsx").then((plots) => ({ default: plots.PlotsPanel })));
const TextPanel = lazy(() => import("../editor/text_panel.tsx"));

export const panels: readonly Panel[] = [
  { id: "mission", title: "Mission", icon: "steps", component: MissionPanel, dock: "left", shortcut: "1" },
  {
    ...kPreflightPlace,
    icon: "checklist",
    component: PreflightPanel,
    useBadge: usePreflightBadge,
    useIsThere: useHasVehicles,
  },
  { id: "robots", title: "Robots", icon: "robots", component: RobotsPanel, dock: "left", shortcut: "2" },
  { id: "overlay", title: "Draw", icon: "draw", component: OverlayPanel, dock: "left", shortcut: "3" },
  { id: "world", title: "World", icon: "world", component: WorldPanel, dock: "left", shortcut: "4" },
  { id: "selection", title: "Selection", icon: "selection", component: SelectionPanel, dock: "right", shortcut: "5" },
  {
    id: "teleoperation",
    title: "Teleoperation",
    short: "Steer",
    icon: "drive",
    component: TeleoperationPanel,
    dock: "right",
    shortcut: "6",
    useBadge: useSteeredUnits,
  },
  { ...kFailsafesPlace, icon: "shield", component: FailsafesPanel },
  {
    ...kMachinesPlace,
    icon: "machine",
    component: MachinesPanel,
    useBadge: useMachinesBadge,
    useIsThere: useHasMachines,
  },
  { id: "view", title: "View", icon: "layers", component: ViewPanel, dock: "right", shortcut: "7" },
  { id: "log", title: "Log", icon: "log", component: LogPanel, dock: "bottom", shortcut: "8" },
  { id: "text", title: "Text", icon: "text", component: TextPanel, dock: "bottom", shortcut: "9" },
  { id: "plots", title: "Plots", icon: "plot", component: PlotsPanel, dock: "bottom", shortcut: "0" },
  {
    id: "breakpoints",
    title: "Breakpoints",
    short: "Breaks",
    icon: "breakpoint",
    component: BreakpointsPanel,
    dock: "bottom",
    useBadge: useBreakpointsBadge,
  },
];

/** Beside selecting, which the map does by itself. */
export const tools: readonly Tool[] = [
  {
    id: "command",
    label: "Command",
    icon: "command",
    shortcut: "o",
    make: (session) => new CommandTool(session),
    options: CommandOptions,
    forOperator: true,
  },
  {
    id: "draw",
    label: "Draw the overlay",
    icon: "draw",
    shortcut: "d",
    make: (session) => new DrawTool(session),
    options: DrawOptions,
    forOperator: true,
  },
  {
    id: "world",
    label: "Edit the world",
    icon: "world",
    shortcut: "w",
    make: (session) => new WorldTool(session),
    options: WorldOptions,
    forOperator: true,
  },
  {
    id: "measure",
    label: "Measure",
    icon: "ruler",
    shortcut: "m",
    make: makeMeasureTool,
    options: MeasureOptions,
  },
];

/** Beside those of the shell itself. */
export const actionSources: readonly ActionSource[] = [removeActions, nameActions];
