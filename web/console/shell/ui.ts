// What only this browser knows: layout, tool, theme, open dialogs; kept over reloads where a person would expect it.

import type { MapView } from "../../core/map/map_view.ts";
import type { MapSettings } from "../../core/map/settings.ts";
import type { Model } from "../../core/model.ts";
import { Store } from "../../core/store.ts";
import {
  emptyHistory,
  type LocalHistory,
  type MissionEdits,
  nextRedo,
  nextUndo,
  recordEdit,
  redoLocal,
  undoLocal,
} from "../undo/history.ts";
import { type Layout, type LayoutEdit, readLayout } from "./layout.ts";
import { readMapSettings } from "./map_settings.ts";

export type ThemeChoice = "auto" | "light" | "dark";

/** What a local edit changes: the layout, or how the map looks. */
export type LocalState = { layout: Layout } | { map: MapSettings };

export type DialogName = "palette" | "shortcuts" | "open" | "new" | "save-as" | "hand-over" | "leave" | "";

export interface UiParts {
  layout: Layout;
  history: LocalHistory<LocalState>;
  theme: ThemeChoice;
  /** How the person is shown to others. */
  name: string;
  /** Id of the tool that is held; empty: selecting. */
  tool: string;
  dialog: DialogName;
  /** The map, while it is shown. */
  map: MapView | null;
  /** Alerts up to this log entry were dismissed, and these. */
  dismissedTo: bigint;
  dismissed: ReadonlySet<bigint>;
  /** Where the text editor shall go; a new object each time. */
  reveal: { document: string; line: number } | null;
  /** Document that the text editor shows; empty: the first. */
  document: string;
  /** A line for the command line; a new object each time. */
  draft: { line: string } | null;
  /** Something went wrong that a person should read; shown until dismissed. */
  notice: { text: string; tone: "danger" | "hold" } | null;
}

const kKey = "mlab.console";

export class Ui extends Store<UiParts> {
  constructor(
    private readonly model: Model,
    private readonly storage: Storage,
    windowWidth: number,
  ) {
    const stored = read(storage);
    super({
      layout: readLayout(stored.layout, windowWidth),
      history: emptyHistory(),
      theme: stored.theme === "light" || stored.theme === "dark" ? stored.theme : "auto",
      name: typeof stored.name === "string" ? stored.name.slice(0, 60) : "",
      tool: "",
      dialog: "",
      map: null,
      dismissedTo: 0n,
      dismissed: new Set(),
      reveal: null,
      document: "",
      draft: null,
      notice: null,
    });
    model.set("map", readMapSettings(stored.map, model.get("map")));
    for (const name of ["layout", "theme", "name"] as const) this.subscribe(name, () => this.keep());
    model.subscribe("map", () => this.keep());
  }

  /** Carries out an edit of the layout; it can be undone. */
  edit({ name, layout }: LayoutEdit): void {
    const before = this.get("layout");
    if (JSON.stringify(before) === JSON.stringify(layout)) return;
    this.record(name, { layout: before }, { layout });
    this.set("layout", layout);
  }

  /** As while a border is dragged: nothing to undo yet. `edit` with the same layout would not be recorded. */
  previewLayout(layout: Layout): void {
    this.set("layout", layout);
  }

  /** What was previewed since `before` becomes one edit. */
  recordLayout(name: string, before: Layout): void {
    const layout = this.get("layout");
    if (JSON.stringify(before) !== JSON.stringify(layout)) this.record(name, { layout: before }, { layout });
  }

  /** Changes how the map looks; it can be undone. */
  editMap(name: string, change: Partial<MapSettings>): void {
    const before = this.model.get("map");
    const map = { ...before, ...change };
    this.record(name, { map: before }, { map });
    this.model.set("map", map);
  }

  /** Undoes the newest edit here, or says that the newest one is the server's. */
  undo(): "local" | "mission" | "nothing" {
    const next = nextUndo(this.get("history"), this.missionEdits());
    if (next?.kind !== "local") return next ? "mission" : "nothing";
    this.set("history", undoLocal(this.get("history")));
    this.apply(next.edit.before);
    return "local";
  }

  redo(): "local" | "mission" | "nothing" {
    const next = nextRedo(this.get("history"), this.missionEdits());
    if (next?.kind !== "local") return next ? "mission" : "nothing";
    this.set("history", redoLocal(this.get("history")));
    this.apply(next.edit.after);
    return "local";
  }

  missionEdits(): MissionEdits {
    return missionEdits(this.model);
  }

  tell(text: string, tone: "danger" | "hold" = "danger"): void {
    this.set("notice", { text, tone });
  }

  private record(name: string, before: LocalState, after: LocalState): void {
    const since = this.missionEdits().undoNumber;
    this.set("history", recordEdit(this.get("history"), { name, before, after, since }));
  }

  private apply(state: LocalState): void {
    if ("layout" in state) this.set("layout", state.layout);
    else this.model.set("map", { ...state.map, theme: this.model.get("map").theme });
  }

  private keep(): void {
    const { layout, theme, name, map } = {
      layout: this.get("layout"),
      theme: this.get("theme"),
      name: this.get("name"),
      map: this.model.get("map"),
    };
    try {
      this.storage.setItem(kKey, JSON.stringify({ layout, theme, name, map }));
    } catch {
      // A full or forbidden storage: the console works, it only forgets.
    }
  }
}

export function missionEdits(model: Model): MissionEdits {
  const edits = model.get("edits");
  return {
    undo: edits?.undo ?? "",
    redo: edits?.redo ?? "",
    undoNumber: edits?.undoNumber ?? 0n,
    redoNumber: edits?.redoNumber ?? 0n,
  };
}

function read(storage: Storage): Record<string, unknown> {
  try {
    const stored: unknown = JSON.parse(storage.getItem(kKey) ?? "{}");
    return typeof stored === "object" && stored !== null ? (stored as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}
