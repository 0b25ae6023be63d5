// Everything that can be done: for keys, menus, the list of commands and the sheet of shortcuts.
import { withToken } from "../../core/server_link.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { isNew } from "../session/designer.ts";
import { innerOf } from "../session/inside.ts";
import { outer } from "../session/pages.ts";
import { goToPane } from "../session/panes.ts";
import { Drawing_Kind } from "../session/protocol.ts";
import { camera, fit } from "../sight/view.ts";
import { startTour } from "../tour/start.ts";
import { arrangeAll } from "./arranging.ts";
import {
  addNote,
  copySelection,
  cutSelection,
  duplicate,
  frameSelection,
  nudge,
  parted,
  paste,
  removeSelection,
  ungroup,
  walk,
} from "./editing.ts";

export function allActions(designer: Designer): Action[] {
  return [
    ...fileActions(designer),
    ...editActions(designer),
    ...goActions(designer),
    ...viewActions(designer),
    ...(designer.extensions.actions?.(designer) ?? []),
    ...helpActions(designer),
  ];
}

const kClosed = "Open a configuration first";

function fileActions(designer: Designer): Action[] {
  const { store, state, document } = designer;
  const closed = document ? undefined : kClosed;
  const dialog = (name: typeof state.dialog) => () => store.setState({ dialog: name, subject: "" });
  const unwritten = document && (document.isReadOnly || isNew(document.path));
  return [
    { id: "new", label: "New configuration", group: "File", icon: "plus", run: () => void designer.open("", "") },
    {
      id: "open",
      label: "Open…",
      group: "File",
      icon: "folder",
      shortcut: "ctrl+o",
      everywhere: true,
      run: dialog("open"),
    },
    {
      id: "save",
      label: unwritten ? "Save…" : "Save",
      group: "File",
      icon: "save",
      shortcut: "ctrl+s",
      everywhere: true,
      blocked: closed,
      run: () => void designer.save(),
    },
    {
      id: "save-as",
      label: "Save as…",
      group: "File",
      shortcut: "ctrl+shift+s",
      everywhere: true,
      blocked: closed,
      run: dialog("save-as"),
    },
    {
      id: "library",
      label: "Save to the library…",
      group: "File",
      icon: "layers",
      blocked: closed,
      run: dialog("library"),
    },
    {
      id: "export-svg",
      label: "Export the drawing as SVG",
      group: "File",
      icon: "plot",
      blocked: closed,
      run: () => void exporting(designer, "svg"),
    },
    {
      id: "export-png",
      label: "Export the drawing as PNG",
      group: "File",
      blocked: closed,
      run: () => void exporting(designer, "png"),
    },
    {
      id: "print",
      label: "Print the drawing",
      group: "File",
      shortcut: "ctrl+p",
      blocked: closed,
      run: () => void exporting(designer, "print"),
    },
    {
      id: "close",
      label: "Close: back to the start page",
      group: "File",
      blocked: closed,
      run: () => designer.leave(),
    },
    {
      id: "console",
      label: "Open the operator console",
      group: "File",
      icon: "robots",
      run: () => window.open(withToken(designer.page, "./"), "_blank", "noopener"),
    },
  ];
}

async function exporting(designer: Designer, what: "svg" | "png" | "print"): Promise<void> {
  const { exportDrawing } = await import("../exports/export.ts");
  await exportDrawing(designer, what);
}

function editActions(designer: Designer): Action[] {
  const { store, document, drawing, state } = designer;
  const parts = parted(designer);
  const closed = drawing ? undefined : kClosed;
  const fixed =
    closed ??
    (drawing!.isReadOnly || document?.isReadOnly ? "This can't be changed: make a copy of your own" : undefined);
  const none = state.selection.length === 0 ? "Nothing is selected" : undefined;
  const noNode = parts.nodes.length === 0 ? "No node is selected" : undefined;
  const oneNode = parts.nodes.length === 1 ? undefined : "Select one node";
  const isFlow = drawing?.kind === Drawing_Kind.DATAFLOW || drawing?.kind === Drawing_Kind.ROBOT;
  const isFile = drawing?.kind === Drawing_Kind.FILE || drawing?.kind === Drawing_Kind.SOCIETY;
  const noPlace = fixed ?? (isFile ? "Nothing can be placed here: add a declaration at the left" : undefined);
  const first = parts.nodes[0] ?? "";
  const show = (dialog: typeof state.dialog, subject = "") => store.setState({ dialog, subject });
  return [
    {
      id: "undo",
      label: document?.undo ? `Undo ${document.undo}` : "Undo",
      group: "Edit",
      icon: "undo",
      shortcut: "ctrl+z",
      blocked: document?.undo ? undefined : "Nothing to undo",
      run: () => designer.undo(),
    },
    {
      id: "redo",
      label: document?.redo ? `Redo ${document.redo}` : "Redo",
      group: "Edit",
      icon: "redo",
      shortcut: "ctrl+shift+z",
      also: ["ctrl+y"],
      blocked: document?.redo ? undefined : "Nothing to redo",
      run: () => designer.redo(),
    },
    {
      id: "remove",
      label: "Remove",
      group: "Edit",
      icon: "close",
      shortcut: "delete",
      also: ["backspace"],
      blocked: fixed ?? none,
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
      blocked: none,
      run: () => designer.select([]),
    },
    {
      id: "rename",
      label: "Rename",
      group: "Edit",
      shortcut: "f2",
      blocked: fixed ?? oneNode,
      run: () => show("rename", first),
    },
    {
      id: "place",
      label: "Place a component",
      group: "Place",
      icon: "search",
      shortcut: "/",
      also: ["space"],
      blocked: noPlace,
      run: () => store.setState({ dialog: "place", placing: null }),
    },
    {
      id: "connect",
      label: drawing?.kind === Drawing_Kind.STATES ? "Add a transition" : "Connect",
      group: "Place",
      icon: "draw",
      shortcut: "c",
      blocked: fixed ?? oneNode,
      run: () => show("connect", first),
    },
    {
      id: "replace",
      label: "Replace",
      group: "Place",
      blocked: noPlace ?? oneNode,
      run: () => store.setState({ dialog: "place", placing: { x: 0, y: 0, replace: first } }),
    },
    {
      id: "group",
      label: "Make an assemblage of the selection",
      group: "Place",
      icon: "layers",
      shortcut: "ctrl+g",
      blocked: fixed ?? noNode ?? (isFlow ? undefined : "Only dataflow can be grouped"),
      run: () => show("group"),
    },
    {
      id: "ungroup",
      label: "Ungroup",
      group: "Place",
      shortcut: "ctrl+shift+g",
      blocked: fixed ?? oneNode,
      run: () => void ungroup(designer, first),
    },
    {
      id: "own-copy",
      label: "Make my own copy",
      group: "Place",
      blocked: document?.isReadOnly ? "Save the file as your own first" : oneNode,
      run: () => void ownCopy(designer, first),
    },
    {
      id: "comment",
      label: "Add a comment",
      group: "Place",
      icon: "text",
      shortcut: "shift+c",
      blocked: fixed,
      run: () => void addNote(designer),
    },
    {
      id: "frame",
      label: "Frame the selection",
      group: "Place",
      shortcut: "shift+f",
      blocked: fixed,
      run: () => frameSelection(designer),
    },
    {
      id: "layout",
      label: "Automatic layout",
      group: "Arrange",
      icon: "steps",
      shortcut: "l",
      blocked: fixed,
      run: () => void arrangeAll(designer),
    },
    ...arrowActions(designer, fixed ?? none, closed),
  ];
}

export async function ownCopy(designer: Designer, name: string): Promise<void> {
  const component = designer.drawing?.nodes.find((node) => node.name === name)?.component ?? "";
  const answer = await designer.edit(`own copy of ${component}`, {
    case: "copyComponent",
    value: { component, name: "" },
  });
  if (answer.ok) designer.say(`${component} is a part of this file now, and can be changed`);
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

function goActions(designer: Designer): Action[] {
  const { state, drawing } = designer;
  const to = drawing && innerOf(drawing, state.selection[0] ?? "");
  return [
    {
      id: "enter",
      label: "Look inside",
      group: "Go",
      icon: "right",
      shortcut: "enter",
      blocked: to ? undefined : "Select something that has an inside",
      run: () => designer.enter(to!),
    },
    {
      id: "up",
      label: "Up one level",
      group: "Go",
      icon: "rewind",
      shortcut: "u",
      blocked: state.page === "" || !drawing ? "This is the whole file" : undefined,
      run: () => {
        const before = designer.crumbs.at(-2);
        designer.goTo(before?.document ?? state.document, before?.page ?? outer(state.page) ?? "");
      },
    },
    {
      id: "file-page",
      label: "The whole file",
      group: "Go",
      shortcut: "home",
      blocked: drawing ? undefined : kClosed,
      run: () => designer.goTo(state.document, ""),
    },
    {
      id: "next-pane",
      label: "To the next part of the page",
      group: "Go",
      shortcut: "f6",
      everywhere: true,
      run: () => goToPane(1),
    },
    {
      id: "previous-pane",
      label: "To the part before",
      group: "Go",
      shortcut: "shift+f6",
      everywhere: true,
      run: () => goToPane(-1),
    },
    {
      id: "link",
      label: "Copy a link to this place",
      group: "Go",
      blocked: drawing ? undefined : kClosed,
      run: () => void copyLink(designer),
    },
  ];
}

async function copyLink(designer: Designer): Promise<void> {
  const { document, page, selection } = designer.state;
  designer.goTo(document, page, selection[0] ?? "");
  await navigator.clipboard
    .writeText(window.location.href)
    .catch(() => designer.tell("The browser does not let the page write to the clipboard."));
  designer.say("Copied the link");
}

function viewActions(designer: Designer): Action[] {
  const { store, state } = designer;
  const { shown } = state;
  const toggle = (
    name: "palette" | "details" | "text" | "problems" | "minimap" | "grid" | "live",
    label: string,
    shortcut: string,
  ): Action => ({
    id: `show-${name}`,
    label: `${shown[name] ? "Hide" : "Show"} ${label}`,
    group: "View",
    shortcut,
    run: () => designer.show({ [name]: !shown[name] }),
  });
  return [
    { id: "fit", label: "Fit everything", group: "View", icon: "fit", shortcut: "f", run: () => fit() },
    {
      id: "fit-selection",
      label: "Fit the selection",
      group: "View",
      shortcut: "shift+1",
      also: ["!"],
      run: () => fit(state.selection),
    },
    {
      id: "zoom-in",
      label: "Zoom in",
      group: "View",
      icon: "plus",
      shortcut: "+",
      also: ["="],
      run: () => void camera()?.zoomIn({ duration: 120 }),
    },
    {
      id: "zoom-out",
      label: "Zoom out",
      group: "View",
      icon: "minus",
      shortcut: "-",
      run: () => void camera()?.zoomOut({ duration: 120 }),
    },
    {
      id: "zoom-one",
      label: "Actual size",
      group: "View",
      shortcut: "1",
      run: () => void camera()?.zoomTo(1, { duration: 120 }),
    },
    toggle("palette", "the components", "b"),
    toggle("details", "the details", "d"),
    toggle("text", "the text", "t"),
    toggle("problems", "the problems", "p"),
    toggle("minimap", "the overview", "m"),
    toggle("grid", "the grid", "g"),
    ...(designer.extensions.live ? [toggle("live", "the map", "r")] : []),
    {
      id: "theme",
      label: `Colours: ${{ auto: "as the system", light: "light", dark: "dark" }[state.theme]}`,
      group: "View",
      icon: "sun",
      run: () => store.setState({ theme: ({ auto: "light", light: "dark", dark: "auto" } as const)[state.theme] }),
    },
  ];
}

function helpActions(designer: Designer): Action[] {
  const { store } = designer;
  return [
    {
      id: "commands",
      label: "All commands",
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
