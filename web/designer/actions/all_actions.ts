// Everything that can be done: for keys, menus, the list of commands and the sheet of shortcuts.
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { startTour } from "../tour/start.ts";
import { blocksOf } from "./blocks.ts";
import { compareActions } from "./compare_actions.ts";
import { arrangeActions, historyActions, selectionActions } from "./edit_actions.ts";
import { fileActions } from "./file_actions.ts";
import { goActions } from "./go_actions.ts";
import { placeActions } from "./place_actions.ts";
import { viewActions } from "./view_actions.ts";

export function allActions(designer: Designer): Action[] {
  const blocks = blocksOf(designer);
  return [
    ...fileActions(designer),
    ...historyActions(designer),
    ...selectionActions(designer, blocks),
    ...placeActions(designer, blocks),
    ...arrangeActions(designer, blocks),
    ...goActions(designer),
    ...viewActions(designer),
    ...compareActions(designer),
    ...(designer.extensions.actions?.(designer) ?? []),
    ...helpActions(designer),
  ];
}

function helpActions(designer: Designer): Action[] {
  const { store } = designer;
  return [
    {
      id: "commands",
      label: "Search everything",
      group: "Help",
      icon: "search",
      shortcut: "ctrl+k",
      everywhere: true,
      run: () => store.setState({ dialog: "commands" }),
    },
    {
      id: "shortcuts",
      label: "Keyboard shortcuts",
      group: "Help",
      icon: "question",
      shortcut: "?",
      run: () => store.setState({ dialog: "shortcuts" }),
    },
    { id: "tour", label: "Guided first tour", group: "Help", icon: "why", run: () => void startTour(designer) },
  ];
}

/** One of them by its id. */
export function action(designer: Designer, id: string): Action | undefined {
  return allActions(designer).find((one) => one.id === id);
}
