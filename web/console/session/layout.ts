// Which panel stands in which dock, which docks are open, and how large they are. Pure: every change gives a new layout.
// What a window shows of it is `fittedLayout`: the map keeps at least half of the window.
import { isRecord } from "../../core/stored.ts";
import type { Dock } from "./registry.ts";

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
  /** The dock that was opened last: where there is room for one alone, it is this one. */
  recent: Dock | "";
}

/** Of the window [CSS px]. */
export interface Room {
  width: number;
  height: number;
}

export interface PanelPlace {
  id: string;
  title: string;
  dock: Dock;
}

/** [px] */
export const kDockSizes: Record<Dock, { least: number; most: number }> = {
  left: { least: 244, most: 560 },
  right: { least: 230, most: 640 },
  bottom: { least: 172, most: 620 },
};

/** Below, a panel lies over the map instead of beside it (as in styles/narrow.css). */
export const kNarrow = 760;

/** What the shell takes beside docks and map, as in ui/styles/shell.css. */
function shellOf({ width }: Room): Room {
  return width < 1400 ? { width: 2 * 48, height: 44 + 34 } : { width: 2 * 68, height: 48 + 40 };
}

/** What a newcomer sees: the steps, and on a wide screen the robots; the rest is a click away. */
export function firstLayout(windowWidth: number): Layout {
  return {
    docks: {
      left: { open: true, size: 312, active: "" },
      right: { open: windowWidth >= 1500, size: 340, active: "" },
      bottom: { open: false, size: 280, active: "" },
    },
    moved: {},
    recent: "",
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

export function showPanel(layout: Layout, panel: PanelPlace): Layout {
  const dock = dockOf(layout, panel);
  return { ...withDock(layout, dock, { open: true, active: panel.id }), recent: dock };
}

/** Shows a panel, or closes its dock where it is shown already: in `shown`, which is `layout` as the window fits it. */
export function togglePanel(layout: Layout, shown: Layout, panels: readonly PanelPlace[], panel: PanelPlace): Layout {
  if (!isShown(shown, panels, panel.id)) return showPanel(layout, panel);
  return withDock(layout, dockOf(layout, panel), { open: false });
}

export function toggleDock(layout: Layout, shown: Layout, dock: Dock): Layout {
  if (shown.docks[dock].open) return withDock(layout, dock, { open: false });
  return { ...withDock(layout, dock, { open: true }), recent: dock };
}

export function resizeDock(layout: Layout, dock: Dock, size: number): Layout {
  const { least, most } = kDockSizes[dock];
  return withDock(layout, dock, { size: Math.round(Math.min(most, Math.max(least, size))) });
}

export function movePanel(layout: Layout, panel: PanelPlace, dock: Dock): Layout {
  const moved = { ...layout.moved };
  if (panel.dock === dock) delete moved[panel.id];
  else moved[panel.id] = dock;
  return { ...withDock({ ...layout, moved }, dock, { open: true, active: panel.id }), recent: dock };
}

/** What the map keeps of the window: half of a small one; a large one has room for more panels. */
function keptShare(room: Room): number {
  return room.width < 1400 ? 0.5 : 0.3;
}

/** Share of the window that the map has, 0 to 1. */
export function mapShare(layout: Layout, room: Room): number {
  const { left, right, bottom } = layout.docks;
  const shell = shellOf(room);
  const width = room.width - shell.width - (left.open ? left.size : 0) - (right.open ? right.size : 0);
  const height = room.height - shell.height - (bottom.open ? bottom.size : 0);
  return (Math.max(0, width) * Math.max(0, height)) / (room.width * room.height);
}

/**
 * The layout as a window of this size shows it: docks become smaller, then those that were not opened last are away
 * until there is room again, so that the map keeps its share of the window. A narrow window shows one panel, over the map.
 */
export function fittedLayout(layout: Layout, room: Room): Layout {
  if (room.width < kNarrow) {
    return kDocks.reduce((out, dock) => (dock === layout.recent ? out : withDock(out, dock, { open: false })), layout);
  }
  const last = layout.recent === "" ? "left" : layout.recent;
  const others = (["bottom", "right", "left"] as const).filter((dock) => dock !== last);
  let out = layout;
  for (const dock of [...others, last]) out = narrowed(out, dock, room);
  for (const dock of others) {
    if (mapShare(out, room) >= keptShare(room)) break;
    if (out.docks[dock].open) out = widened(withDock(out, dock, { open: false }), layout, room);
  }
  return out;
}

/** Whether a panel can be shown without another one going away, as when it opens by itself. */
export function leavesAll(layout: Layout, panel: PanelPlace, room: Room): boolean {
  const before = fittedLayout(layout, room);
  const after = fittedLayout(showPanel(layout, panel), room);
  return room.width >= kNarrow && kDocks.every((dock) => !before.docks[dock].open || after.docks[dock].open);
}

/** As much smaller as the map needs, or as it can be. */
function narrowed(layout: Layout, dock: Dock, room: Room): Layout {
  if (!layout.docks[dock].open || mapShare(layout, room) >= keptShare(room)) return layout;
  const { least } = kDockSizes[dock];
  let size = Math.max(least, layout.docks[dock].size);
  while (size > least && mapShare(withDock(layout, dock, { size }), room) < keptShare(room)) --size;
  return withDock(layout, dock, { size });
}

/** One has gone: what is left may be as large as it was meant, where that fits. */
function widened(layout: Layout, meant: Layout, room: Room): Layout {
  let out = layout;
  for (const dock of kDocks) out = narrowed(withDock(out, dock, { size: meant.docks[dock].size }), dock, room);
  return out;
}

/** What was stored may be of another version, or anything at all: what can't be used is as at first. */
export function readLayout(stored: unknown, windowWidth: number): Layout {
  const layout = firstLayout(windowWidth);
  if (!isRecord(stored)) return layout;
  if (isRecord(stored.docks)) {
    for (const dock of kDocks) layout.docks[dock] = readDock(stored.docks[dock], layout.docks[dock], kDockSizes[dock]);
  }
  if (kDocks.includes(stored.recent as Dock)) layout.recent = stored.recent as Dock;
  if (isRecord(stored.moved)) {
    for (const [id, dock] of Object.entries(stored.moved)) {
      if (kDocks.includes(dock as Dock)) layout.moved[id] = dock as Dock;
    }
  }
  return layout;
}

function readDock(stored: unknown, fallback: DockLayout, { least, most }: { least: number; most: number }): DockLayout {
  if (!isRecord(stored)) return fallback;
  const { open, active, size } = stored;
  const isSize = typeof size === "number" && Number.isFinite(size);
  return {
    open: typeof open === "boolean" ? open : fallback.open,
    active: typeof active === "string" ? active : fallback.active,
    size: isSize ? Math.min(most, Math.max(least, size)) : fallback.size,
  };
}

function withDock(layout: Layout, dock: Dock, change: Partial<DockLayout>): Layout {
  return { ...layout, docks: { ...layout.docks, [dock]: { ...layout.docks[dock], ...change } } };
}
