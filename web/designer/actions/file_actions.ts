// What is done with files: opened, saved, exported, left.
import { withToken } from "../../core/server_link.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { save } from "../session/documents.ts";
import type { DialogName } from "../session/state.ts";
import { isNew } from "../session/titles.ts";
import { kClosed } from "./blocks.ts";

export function fileActions(designer: Designer): Action[] {
  const closed = designer.document ? undefined : kClosed;
  return [
    {
      id: "new",
      label: "New configuration",
      group: "File",
      icon: "plus",
      run: () => void designer.navigation.open("", ""),
    },
    {
      id: "open",
      label: "Open…",
      group: "File",
      icon: "folder",
      shortcut: "ctrl+o",
      everywhere: true,
      run: () => openDialog(designer, "open"),
    },
    ...saveActions(designer, closed),
    ...exportActions(designer, closed),
    {
      id: "close",
      label: "Close: back to the start page",
      group: "File",
      blocked: closed,
      run: () => designer.navigation.leave(),
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

function saveActions(designer: Designer, closed: string | undefined): Action[] {
  const { document } = designer;
  const unwritten = document && (document.isReadOnly || isNew(document.path));
  return [
    {
      id: "save",
      label: unwritten ? "Save…" : "Save",
      group: "File",
      icon: "save",
      shortcut: "ctrl+s",
      everywhere: true,
      blocked: closed,
      run: () => void save(designer),
    },
    {
      id: "save-as",
      label: "Save as…",
      group: "File",
      shortcut: "ctrl+shift+s",
      everywhere: true,
      blocked: closed,
      run: () => openDialog(designer, "save-as"),
    },
    {
      id: "library",
      label: "Save to the library…",
      group: "File",
      icon: "layers",
      blocked: closed,
      run: () => openDialog(designer, "library"),
    },
  ];
}

function openDialog({ store }: Designer, dialog: DialogName): void {
  store.setState({ dialog, subject: "" });
}

function exportActions(designer: Designer, closed: string | undefined): Action[] {
  return [
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
  ];
}

async function exporting(designer: Designer, what: "svg" | "png" | "print"): Promise<void> {
  const { exportDrawing } = await import("../exports/export.ts");
  await exportDrawing(designer, what);
}
