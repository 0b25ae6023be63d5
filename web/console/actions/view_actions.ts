// What stands where on the page, and how it looks.
import type { ActionRow } from "../../ui/commands/declared.ts";
import { panels } from "../extensions/extensions.ts";
import { firstLayout, kDocks, toggleDock, togglePanel } from "../session/layout.ts";
import type { ActionTable, Dock, Panel } from "../session/registry.ts";
import type { Session } from "../session/session.ts";

export const kViewTable: ActionTable = {
  group: "View",
  rows: [
    {
      id: "palette",
      label: "Search everything…",
      icon: "search",
      shortcut: "ctrl+k",
      everywhere: true,
      run: ({ ui }) => ui.set("dialog", ui.get("dialog") === "palette" ? "" : "palette"),
    },
    { id: "shortcuts", label: "Keyboard shortcuts", shortcut: "?", run: ({ ui }) => ui.set("dialog", "shortcuts") },
    ...panels.map(panelRow),
    ...kDocks.map(dockRow),
    {
      id: "command-line",
      label: "Type a command",
      icon: "command",
      shortcut: "/",
      run: () => document.getElementById("command-line")?.focus(),
    },
    {
      id: "reset-layout",
      label: "Reset the layout",
      run: ({ ui }) => ui.set("layout", firstLayout(window.innerWidth)),
    },
    themeRow("light", "Light colours"),
    themeRow("dark", "Dark colours"),
    themeRow("auto", "Colours as the system has them"),
  ],
};

function panelRow(panel: Panel): ActionRow<Session> {
  return {
    id: `panel-${panel.id}`,
    label: `${panel.title} panel`,
    icon: panel.icon,
    ...(panel.shortcut ? { shortcut: panel.shortcut } : {}),
    run: ({ ui }) => ui.set("layout", togglePanel(ui.get("layout"), ui.shownLayout, panels, panel)),
  };
}

function dockRow(dock: Dock): ActionRow<Session> {
  const name = dock === "bottom" ? "drawer" : `${dock} side`;
  return {
    id: `dock-${dock}`,
    label: ({ ui }) => `${ui.shownLayout.docks[dock].open ? "Close" : "Open"} the ${name}`,
    shortcut: { left: "ctrl+b", right: "ctrl+shift+b", bottom: "ctrl+j" }[dock],
    run: ({ ui }) => ui.set("layout", toggleDock(ui.get("layout"), ui.shownLayout, dock)),
  };
}

function themeRow(theme: "light" | "dark" | "auto", label: string): ActionRow<Session> {
  return {
    id: `theme-${theme}`,
    label,
    icon: "sun",
    unless: [({ ui }) => (ui.get("theme") === theme ? "They are chosen." : undefined)],
    run: ({ ui }) => ui.set("theme", theme),
  };
}
