// What is done with the mission's texts: opened, saved, changed back.
import type { Hindrance } from "../../ui/commands/declared.ts";
import { elsewhen } from "../session/elsewhen.ts";
import { nameOf, nextRedo, nextUndo } from "../session/history.ts";
import { redo, save, undo } from "../session/orders.ts";
import type { ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { allSaved, noDocuments, onlyWatching } from "./hindrances.ts";

export const kMissionTable: ActionTable = {
  group: "Mission",
  rows: [
    {
      id: "open",
      label: "Open a mission…",
      icon: "folder",
      shortcut: "ctrl+o",
      unless: [onlyWatching],
      run: ({ ui }) => ui.set("dialog", "open"),
    },
    {
      id: "new",
      label: "New mission…",
      icon: "file",
      unless: [onlyWatching],
      run: ({ ui }) => ui.set("dialog", "new"),
    },
    {
      id: "save",
      label: "Save",
      icon: "save",
      shortcut: "ctrl+s",
      everywhere: true,
      unless: [onlyWatching, noDocuments, allSaved],
      run: (session) => save(session),
    },
    {
      id: "save-as",
      label: "Save as…",
      icon: "save",
      shortcut: "ctrl+shift+s",
      everywhere: true,
      unless: [onlyWatching, noDocuments],
      run: ({ ui }) => ui.set("dialog", "save-as"),
    },
  ],
};

/** Edits of how the map looks are undone at any moment, those of the mission are not. */
function missionIsElsewhen(next: typeof nextUndo): Hindrance<Session> {
  return ({ model, ui }) =>
    next(ui.get("history"), ui.missionEdits())?.kind === "mission" ? elsewhen(model) : undefined;
}

/** What would be taken back; empty: nothing. */
function undoName({ ui }: Session): string {
  return nameOf(nextUndo(ui.get("history"), ui.missionEdits()));
}

function redoName({ ui }: Session): string {
  return nameOf(nextRedo(ui.get("history"), ui.missionEdits()));
}

export const kEditTable: ActionTable = {
  group: "Edit",
  rows: [
    {
      id: "undo",
      label: (session) => `Undo ${undoName(session)}`.trim(),
      icon: "undo",
      shortcut: "ctrl+z",
      unless: [(session) => (undoName(session) ? undefined : "There is nothing to undo."), missionIsElsewhen(nextUndo)],
      run: (session) => undo(session),
    },
    {
      id: "redo",
      label: (session) => `Redo ${redoName(session)}`.trim(),
      icon: "redo",
      shortcut: "ctrl+shift+z",
      unless: [(session) => (redoName(session) ? undefined : "There is nothing to redo."), missionIsElsewhen(nextRedo)],
      run: (session) => redo(session),
    },
  ],
};
