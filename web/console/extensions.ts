// Everything that stands in the shell, in the order of the tabs and buttons.
import type { Action, Panel, Tool } from "./registry";

export const panels: Panel[] = [];
export const tools: Tool[] = [];
/** Beside those of the shell itself (actions/shell_actions.ts). */
export const moreActions: Action[] = [];
