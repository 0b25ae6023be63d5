// What can be put into the shell: panels in its docks, tools on its map, actions in menus, palette and shortcuts.
// They stand in ../extensions/extensions.ts, one line each; the shell knows none of them by name.

import type { ComponentType } from "react";
import type { MapTool } from "../../core/map/tool.ts";
import type { DeclaredAction, ActionTable as DeclaredTable } from "../../ui/commands/declared.ts";
import type { IconName } from "../../ui/controls/icons.tsx";
import type { Session } from "./session.ts";

export type Dock = "left" | "right" | "bottom";

export interface Panel {
  id: string;
  title: string;
  /** In the rail, where there is room for about nine letters; the title without. */
  short?: string;
  icon: IconName;
  /** Rendered only while it is shown; `lazy()` for what brings a large library. */
  component: ComponentType;
  /** Where it stands until somebody moves it. */
  dock: Dock;
  shortcut?: string;
  /** A number on its button, as of things that want attention. A hook. */
  useBadge?: () => number;
  /** Whether it has a button at all: of things that not every mission has. A hook. */
  useIsThere?: () => boolean;
}

export interface Tool {
  id: string;
  label: string;
  icon: IconName;
  /** As in ui/commands/keys.ts: `m`, `shift+o`. */
  shortcut?: string;
  /** A new one each time the tool is taken up; dropped when another one is. */
  make: (session: Session) => MapTool;
  /** Shown over the map while the tool is held: what to do, and its settings. */
  options?: ComponentType;
  /** Tools that change the mission are out of reach of who only watches. */
  forOperator?: boolean;
  /** Only in the palette and by shortcut, or taken up by a panel: no button over the map. */
  hidden?: boolean;
}

export type Action = DeclaredAction<ActionGroup>;

/** Actions of one group, as they are declared; see ui/commands/declared.ts. */
export type ActionTable = DeclaredTable<Session, ActionGroup>;

export type ActionGroup = "Run" | "Time" | "Mission" | "Map" | "Tools" | "Selection" | "Edit" | "View" | "People";

/** Asked for anew each time they are shown or a key is pressed, so `blocked` tells how things stand. */
export type ActionSource = (session: Session) => readonly Action[];
