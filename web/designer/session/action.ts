import type { IconName } from "../../ui/controls/icons.tsx";

export type ActionGroup = "File" | "Edit" | "Place" | "Arrange" | "Go" | "View" | "Run" | "Help";

/** Something that can be done: in menus, in the list of all commands, by a key. */
export interface Action {
  id: string;
  label: string;
  group: ActionGroup;
  icon?: IconName;
  /** As `ctrl+shift+z`, `f`. */
  shortcut?: string;
  /** More keys that do the same. */
  also?: readonly string[];
  /** Also while a text has the focus. */
  everywhere?: boolean;
  /** Why it can't be done now. */
  blocked?: string | undefined;
  run: () => void;
}
