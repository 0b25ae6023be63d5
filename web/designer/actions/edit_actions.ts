// What is done with what stands on the page: taken back, taken away, copied, selected, moved.
import { takeBack } from "../names/rename.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { redo, undo } from "../session/documents.ts";
import { arrangeAll } from "./arranging.ts";
import type { Blocks } from "./blocks.ts";
import {
  copySelection,
  cutSelection,
  duplicate,
  nudge,
  paste,
  removeSelection,
  selectionByKind,
  walk,
} from "./editing.ts";

export function historyActions(designer: Designer): Action[] {
  const { document } = designer;
  return [
    {
      id: "undo",
      label: document?.undo ? `Undo ${document.undo}` : "Undo",
      group: "Edit",
      icon: "undo",
      shortcut: "ctrl+z",
      blocked: document?.undo ? undefined : "Nothing to undo",
      run: () => undo(designer),
    },
    {
      id: "redo",
      label: document?.redo ? `Redo ${document.redo}` : "Redo",
      group: "Edit",
      icon: "redo",
      shortcut: "ctrl+shift+z",
      also: ["ctrl+y"],
      blocked: document?.redo ? undefined : "Nothing to redo",
      run: () => redo(designer),
    },
  ];
}

export function selectionActions(designer: Designer, blocks: Blocks): Action[] {
  const { store, drawing } = designer;
  const { closed, fixed, noSelection, notOneNode } = blocks;
  const first = selectionByKind(designer).nodes[0] ?? "";
  return [
    ...clipboardActions(designer, blocks),
    {
      id: "all",
      label: "Select all",
      group: "Edit",
      shortcut: "ctrl+a",
      blocked: closed,
      run: () => designer.select([...drawing!.nodes, ...drawing!.states].map((one) => one.name)),
    },
    {
      id: "none",
      label: "Select nothing",
      group: "Edit",
      shortcut: "escape",
      blocked: noSelection,
      run: () => designer.select([]),
    },
    {
      id: "rename",
      label: "Rename",
      group: "Edit",
      shortcut: "f2",
      blocked: fixed ?? notOneNode,
      run: () => store.setState({ dialog: "rename", subject: first }),
    },
    {
      id: "take-back-renaming",
      label: "Take back the last renaming, in all files",
      group: "Edit",
      run: () => void takeBack(designer),
    },
  ];
}

function clipboardActions(designer: Designer, { closed, fixed, noSelection, noNode }: Blocks): Action[] {
  return [
    {
      id: "remove",
      label: "Remove",
      group: "Edit",
      icon: "close",
      shortcut: "delete",
      also: ["backspace"],
      blocked: fixed ?? noSelection,
      run: () => void removeSelection(designer),
    },
    {
      id: "copy",
      label: "Copy",
      group: "Edit",
      shortcut: "ctrl+c",
      blocked: closed ?? noNode,
      run: () => void copySelection(designer),
    },
    {
      id: "cut",
      label: "Cut",
      group: "Edit",
      shortcut: "ctrl+x",
      blocked: fixed ?? noNode,
      run: () => void cutSelection(designer),
    },
    { id: "paste", label: "Paste", group: "Edit", shortcut: "ctrl+v", blocked: fixed, run: () => void paste(designer) },
    {
      id: "duplicate",
      label: "Duplicate",
      group: "Edit",
      shortcut: "ctrl+d",
      blocked: fixed ?? noNode,
      run: () => void duplicate(designer),
    },
  ];
}

export function arrangeActions(designer: Designer, { closed, fixed, noSelection }: Blocks): Action[] {
  return [
    {
      id: "layout",
      label: "Automatic layout",
      group: "Arrange",
      icon: "steps",
      shortcut: "l",
      blocked: fixed,
      run: () => void arrangeAll(designer),
    },
    ...arrowActions(designer, fixed ?? noSelection, closed),
  ];
}

const kArrows = [
  ["arrowleft", -1, 0, "left"],
  ["arrowright", 1, 0, "right"],
  ["arrowup", 0, -1, "up"],
  ["arrowdown", 0, 1, "down"],
] as const;

function arrowActions(designer: Designer, blocked: string | undefined, closed: string | undefined): Action[] {
  return kArrows.flatMap(([key, dx, dy, word]): Action[] => [
    {
      id: `nudge-${word}`,
      label: `Move the selection ${word}`,
      group: "Arrange",
      shortcut: key,
      blocked,
      run: () => nudge(designer, dx * 8, dy * 8),
    },
    {
      id: `push-${word}`,
      label: `Move the selection far ${word}`,
      group: "Arrange",
      shortcut: `shift+${key}`,
      blocked,
      run: () => nudge(designer, dx * 48, dy * 48),
    },
    {
      id: `walk-${word}`,
      label: `Select the next node ${word}`,
      group: "Go",
      shortcut: `alt+${key}`,
      blocked: closed,
      run: () => walk(designer, dx, dy),
    },
  ]);
}
