// Everything that stands in the shell, in the order of its buttons.
import { LogPanel } from "./log/log_panel.tsx";
import { MissionPanel } from "./mission/mission_panel.tsx";
import type { ActionSource, Panel, Tool } from "./registry.ts";

export const panels: readonly Panel[] = [
  { id: "mission", title: "Mission", icon: "steps", component: MissionPanel, dock: "left", shortcut: "1" },
  { id: "log", title: "Log", icon: "log", component: LogPanel, dock: "bottom", shortcut: "8" },
];

/** Beside selecting, which the map does by itself. */
export const tools: readonly Tool[] = [];

/** Beside those of the shell itself. */
export const actionSources: readonly ActionSource[] = [];
