// What only this browser knows: layout, tool, theme, open dialogs; kept over reloads where a person would expect it.

import type { MapView } from "../../core/map/map_view.ts";
import type { MapSettings } from "../../core/map_settings.ts";
import type { Model } from "../../core/model.ts";
import type { UseList } from "../../core/names.ts";
import { Store } from "../../core/store.ts";
import { readRecord } from "../../core/stored.ts";
import type { ThemeChoice } from "../../ui/controls/theme.ts";
import {
  emptyHistory,
  type LocalHistory,
  type MissionEdits,
  nextRedo,
  nextUndo,
  recordEdit,
  redoLocal,
  undoLocal,
} from "./history.ts";
import { fittedLayout, type Layout, type Room, readLayout } from "./layout.ts";
import { readMapSettings } from "./map_settings.ts";

/** What a local edit changes: how the map looks. Panels come and go without one: Undo is for the mission. */
export type LocalState = { map: MapSettings };

export type DialogName =
  | "abort"
  | "restart"
  | "palette"
  | "shortcuts"
  | "open"
  | "new"
  | "save-as"
  | "hand-over"
  | "leave"
  | "rename"
  | "";

/** A text that is none of the mission's, and only read. */
export interface LookedText {
  path: string;
  text: string;
}

/** What was looked for in all files. */
export type UsesShown = { is: "asking"; word: string } | { is: "found"; list: UseList; places: number };

export interface Notice {
  text: string;
  tone: "danger" | "hold" | "accent";
  action?: { label: string; run: () => void };
}

export interface UiParts {
  /** As the person wants it; `shownLayout` is what there is room for. */
  layout: Layout;
  /** The window's size. */
  room: Room;
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
  reveal: { document: string; line: number; span?: { begin: number; end: number } } | null;
  /** Document that the text editor shows; empty: the first. */
  document: string;
  /** Shown in the text editor beside the documents. */
  looked: readonly LookedText[];
  uses: UsesShown | null;
  /** What gets another name, and how it is called now. */
  renaming: { at: { document: string; cursor: number }; first: string } | null;
  /** A line for the command line; a new object each time. */
  draft: { line: string } | null;
  /** An emergency stop was asked for here, and has not been confirmed by every robot. */
  stopSent: boolean;
  /** The run was told here to start, and has not answered for a while: what it waits for is a vehicle, as a rule. */
  isStarting: boolean;
  /** Whether questions and alerts are heard and seen outside of the page as well. */
  calls: boolean;
  /** All alerts are listed, not the newest alone. */
  alertsUnfolded: boolean;
  /** Something went wrong that a person should read; shown until dismissed. */
  notice: Notice | null;
}

const kKey = "mlab.console";

export class Ui extends Store<UiParts> {
  constructor(
    private readonly model: Model,
    private readonly storage: Storage,
    room: Room,
  ) {
    const stored = readRecord(storage.getItem(kKey));
    super({
      layout: readLayout(stored.layout, room.width),
      room,
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
      looked: [],
      uses: null,
      renaming: null,
      draft: null,
      notice: null,
      stopSent: false,
      isStarting: false,
      calls: stored.calls === true,
      alertsUnfolded: false,
    });
    model.set("map", readMapSettings(stored.map, model.get("map")));
    for (const name of ["layout", "theme", "name", "calls"] as const) this.subscribe(name, () => this.keep());
    model.subscribe("map", () => this.keep());
  }

  /** The layout as the window shows it. */
  get shownLayout(): Layout {
    return fittedLayout(this.get("layout"), this.get("room"));
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
    this.model.set("map", { ...state.map, theme: this.model.get("map").theme });
  }

  private keep(): void {
    const { layout, theme, name, calls, map } = {
      layout: this.get("layout"),
      theme: this.get("theme"),
      name: this.get("name"),
      calls: this.get("calls"),
      map: this.model.get("map"),
    };
    try {
      this.storage.setItem(kKey, JSON.stringify({ layout, theme, name, calls, map }));
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
