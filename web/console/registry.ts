// What can be put into the shell: panels in its docks, tools on its map, actions in menus, palette and shortcuts.
// They stand in extensions.ts, one line each; the shell knows none of them by name.
import type { ComponentType, ReactNode } from "react";
import type { MapTool } from "../core/map/tool";

export type Dock = "left" | "right" | "bottom";

export interface Panel {
  id: string;
  title: string;
  icon: ReactNode;
  component: ComponentType;
  /** Where it stands until somebody moves it. */
  dock: Dock;
  /** A number beside the title, as of unread entries. Called while rendering: it may use hooks. */
  useBadge?: () => number;
}

export interface Tool {
  id: string;
  label: string;
  icon: ReactNode;
  /** As in `keys.ts`: `m`, `shift+o`. */
  shortcut?: string;
  /** A new one each time the tool is taken up; dropped when another one is. */
  make: () => MapTool;
  /** Shown over the map while the tool is held: what to do, and its settings. */
  options?: ComponentType;
  /** Tools that change the mission are out of reach of who only watches. */
  forOperator?: boolean;
}

export interface Action {
  id: string;
  /** As in a menu: `Pause`, `Fit the map`. */
  label: string;
  group: ActionGroup;
  shortcut?: string;
  /** Also while a text field has the focus. */
  everywhere?: boolean;
  /** Why it can't be done now, as a sentence; nothing: it can. */
  blocked?: () => string | undefined;
  run: () => void;
}

export type ActionGroup = "Run" | "Mission" | "Map" | "Selection" | "Edit" | "View" | "People";
