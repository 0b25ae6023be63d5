import type { Command } from "../../ui/commands/commands.tsx";

export type ActionGroup = "File" | "Edit" | "Place" | "Arrange" | "Go" | "View" | "Compare" | "Run" | "Time" | "Help";

/** Something that can be done: in menus, in the list of all commands, by a key. */
export interface Action extends Command {
  group: ActionGroup;
  /** More keys that do the same. */
  also?: readonly string[];
  /** Also while a text has the focus. */
  everywhere?: boolean;
}
