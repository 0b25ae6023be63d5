// Which panel stands in which dock, which docks are open, and how large they are. Pure: every change gives a new layout
// and says in words what it did, for undo.
import type { Dock } from "../registry.ts";

export const kDocks: readonly Dock[] = ["left", "right", "bottom"];

export interface DockLayout {
  open: boolean;
  size: number; // [px] width, of the bottom dock height
  active: string; // id of the panel that is shown; empty: the first
}

export interface Layout {
  docks: Record<Dock, DockLayout>;
  /** Panels that were moved out of the dock they came with. */
  moved: Record<string, Dock>;
}

export interface PanelPlace {
  id: string;
  title: string;
  dock: Dock;
}

export interface LayoutEdit {
  name: string;
  layout: Layout;
}

const kLimits: Record<Dock, { min: number; max: number }> = {
  left: { min: 240, max: 560 },
  right: { min: 260, max: 640 },
  bottom: { min: 140, max: 620 },
};

/** What a newcomer sees: the steps, and on a wide screen the robots; the rest is a click away. */
export function firstLayout(windowWidth: number): Layout {
  return {
    docks: {
      left: { open: true, size: 312, active: "" },
      right: { open: windowWidth >= 1500, size: 340, active: "" },
      bottom: { open: false, size: 280, active: "" },
    },
    moved: {},
  };
}

/** The dock in which a panel stands. */
export function dockOf(layout: Layout, panel: PanelPlace): Dock {
  return layout.moved[panel.id] ?? panel.dock;
}

export function panelsIn<P extends PanelPlace>(layout: Layout, panels: readonly P[], dock: Dock): P[] {
  return panels.filter((panel) => dockOf(layout, panel) === dock);
}

/** The panel that is shown in a dock: the active one, or the first where that is elsewhere. */
export function activePanel<P extends PanelPlace>(layout: Layout, panels: readonly P[], dock: Dock): P | undefined {
  const here = panelsIn(layout, panels, dock);
  return here.find((panel) => panel.id === layout.docks[dock].active) ?? here[0];
}

export function isShown(layout: Layout, panels: readonly PanelPlace[], id: string): boolean {
  return kDocks.some((dock) => layout.docks[dock].open && activePanel(layout, panels, dock)?.id === id);
}

export function showPanel(layout: Layout, panel: PanelPlace): LayoutEdit {
  const dock = dockOf(layout, panel);
  return { name: `show ${panel.title}`, layout: withDock(layout, dock, { open: true, active: panel.id }) };
}

/** Shows a panel, or closes its dock where it is shown already. */
export function togglePanel(layout: Layout, panels: readonly PanelPlace[], panel: PanelPlace): LayoutEdit {
  if (!isShown(layout, panels, panel.id)) return showPanel(layout, panel);
  const dock = dockOf(layout, panel);
  return { name: `hide ${panel.title}`, layout: withDock(layout, dock, { open: false }) };
}

export function toggleDock(layout: Layout, dock: Dock): LayoutEdit {
  const open = !layout.docks[dock].open;
  return { name: `${open ? "open" : "close"} the ${dock} panel`, layout: withDock(layout, dock, { open }) };
}

/** `room`: what the window has to give [px]; the map keeps at least 260 of it. */
export function resizeDock(layout: Layout, dock: Dock, size: number, room: number): LayoutEdit {
  const { min, max } = kLimits[dock];
  const most = Math.max(min, Math.min(max, room - 260));
  const bounded = Math.round(Math.min(most, Math.max(min, size)));
  return { name: `resize the ${dock} panel`, layout: withDock(layout, dock, { size: bounded }) };
}

export function movePanel(layout: Layout, panel: PanelPlace, dock: Dock): LayoutEdit {
  const moved = { ...layout.moved };
  if (panel.dock === dock) delete moved[panel.id];
  else moved[panel.id] = dock;
  return {
    name: `move ${panel.title} to the ${dock}`,
    layout: withDock({ ...layout, moved }, dock, { open: true, active: panel.id }),
  };
}

export function resetLayout(windowWidth: number): LayoutEdit {
  return { name: "reset the layout", layout: firstLayout(windowWidth) };
}

/** What was stored may be of another version, or anything at all: what can't be used is as at first. */
export function readLayout(stored: unknown, windowWidth: number): Layout {
  const layout = firstLayout(windowWidth);
  if (!isRecord(stored)) return layout;
  if (isRecord(stored.docks)) {
    for (const dock of kDocks) {
      const from = stored.docks[dock];
      if (!isRecord(from)) continue;
      const into = layout.docks[dock];
      if (typeof from.open === "boolean") into.open = from.open;
      if (typeof from.active === "string") into.active = from.active;
      if (typeof from.size === "number" && Number.isFinite(from.size)) {
        into.size = Math.min(kLimits[dock].max, Math.max(kLimits[dock].min, from.size));
      }
    }
  }
  if (isRecord(stored.moved)) {
    for (const [id, dock] of Object.entries(stored.moved)) {
      if (kDocks.includes(dock as Dock)) layout.moved[id] = dock as Dock;
    }
  }
  return layout;
}

function withDock(layout: Layout, dock: Dock, change: Partial<DockLayout>): Layout {
  return { ...layout, docks: { ...layout.docks, [dock]: { ...layout.docks[dock], ...change } } };
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
