// What the page knows: what the server tells, what is looked at, what is open. Values are replaced, never changed in place.

import { createStore, type StoreApi } from "zustand/vanilla";
import type { LinkState } from "../../core/server_link.ts";
import { isRecord, readRecord } from "../../core/stored.ts";
import type { ThemeChoice } from "../../ui/controls/theme.ts";
import type { Crumb } from "./crumbs.ts";
import { pageKey } from "./pages.ts";
import {
  type Differences,
  type Document,
  type Drawing,
  type FileChanged,
  type Hello,
  type Mark,
  type PageDifference,
  type Palette,
  type TestList,
  TestList_State,
  type UseList,
} from "./protocol.ts";

export type DialogName =
  | ""
  | "place" // search palette
  | "connect"
  | "trigger"
  | "commands"
  | "shortcuts"
  | "open"
  | "save-as"
  | "library"
  | "group"
  | "rename"
  | "rename-name" // of a text, or what was typed into a field
  | "parameter"
  | "declaration"
  | "device" // what serves a binding point
  | "compare"
  | "welcome";

/** What is shown beside the canvas; kept over reloads. */
export interface ShownPanes {
  palette: boolean;
  details: boolean;
  text: boolean;
  problems: boolean;
  /** Tests of components. */
  tests: boolean;
  /** The map of the embedded simulator. */
  live: boolean;
  /** The palette has made room for the map or the text, and comes back with its end. */
  paletteWaits: boolean;
  minimap: boolean;
  grid: boolean;
  /** [px] */
  paletteWidth: number;
  detailsWidth: number;
  textWidth: number;
  liveWidth: number;
  problemsHeight: number;
}

export interface Notice {
  text: string;
  tone: "danger" | "hold" | "accent";
  /** What can be done about it. */
  action?: { label: string; run: () => void };
}

/** What a device, or a new one, is asked for. */
export interface DeviceChoice {
  /** The class of robots or the operator. */
  owner: string;
  /** Empty: a new one. */
  device: string;
  /** The binding point that it serves; empty: that is asked first. */
  binds: string;
}

/** What is given another name. */
export interface Renaming {
  at: { document: string; cursor?: number; isDrawn?: boolean; page?: string; node?: string; ofComponent?: boolean };
  first: string;
  /** What was typed already. */
  name?: string;
}

/** What the search palette is for: a place on the canvas, perhaps an input that waits for it. */
export interface Placing {
  x: number;
  y: number;
  /** Not the one that is shown: that of a trigger. */
  page?: string;
  /** Connected to this input at once. */
  to?: { node: string; port: string; index?: number | undefined };
  /** An output that the new one is to take. */
  from?: string;
  /** Puts it in this node's place. */
  replace?: string;
}

/** What a component is chosen for: the part itself, or something beside it. */
export interface TriggerChoice {
  from: string;
  index: number;
  /** Which operand of which operand; empty: the whole trigger. */
  part: readonly number[];
  how: "choose" | "and" | "or";
}

/** Where the text editor shall go; a new object each time. */
export interface Reveal {
  begin: number;
  end: number;
  focus: boolean;
}

export interface State {
  link: LinkState;
  hello: Hello | null;
  /** Those that this page has opened, by path. */
  documents: Readonly<Record<string, Document>>;
  /** By pageKey. */
  drawings: Readonly<Record<string, Drawing>>;
  palettes: Readonly<Record<string, Palette>>;
  changed: Readonly<Record<string, FileChanged>>;
  /** Why what is not saved would be lost with the server; empty: it is kept. */
  notKept: string;
  /** Probes and breakpoints, by document. */
  marks: Readonly<Record<string, readonly Mark[]>>;
  /** Tests of components, by the document that they are listed for. */
  tests: Readonly<Record<string, TestList>>;
  /** What differs from the version that a document is compared with, by document. */
  differences: Readonly<Record<string, Differences>>;
  /** The same on pages, by pageKey. */
  pageDifferences: Readonly<Record<string, PageDifference>>;
  /** What was only moved is told as well. */
  showsMoved: boolean;
  /** The one of all that are told that one has gone to last; -1: none. */
  difference: number;
  /** Path of the document that is shown; empty: the start page. */
  document: string;
  /** Path of the page that is shown. */
  page: string;
  /** The pages from which one went inside of something, to get here. */
  trail: readonly Crumb[];
  /** Names of nodes, states or declarations; `From/0` for a transition; `note:1`. */
  selection: readonly string[];
  dialog: DialogName;
  placing: Placing | null;
  triggerChoice: TriggerChoice | null;
  deviceChoice: DeviceChoice | null;
  /** What a dialog is about: the node that is renamed, say. */
  subject: string;
  shown: ShownPanes;
  theme: ThemeChoice;
  notice: Notice | null;
  reveal: Reveal | null;
  renaming: Renaming | null;
  /** What was looked for: its places are listed below the drawing. */
  uses: UseList | null;
  /** Something is looked for on the page. */
  isFinding: boolean;
  /** Step of the first tour; -1: not shown. */
  tour: number;
  /** The step was done before it came: it waits for who reads it. */
  tourWaits: boolean;
  /** Said to people who can't see it. */
  spoken: string;
}

export type Store = StoreApi<State>;

const kKey = "mlab.designer";

export function firstShown(windowWidth: number): ShownPanes {
  return {
    palette: true,
    details: true,
    text: windowWidth >= 1700,
    problems: false,
    tests: false,
    live: false,
    paletteWaits: false,
    minimap: true,
    grid: true,
    paletteWidth: 232,
    detailsWidth: 288,
    textWidth: 440,
    liveWidth: 420,
    problemsHeight: 180,
  };
}

export function createState(storage: Storage, windowWidth: number): Store {
  const stored = readRecord(storage.getItem(kKey));
  const store = createStore<State>(() => ({
    link: { state: "connecting", reason: "", retryAt: 0, silentSince: 0 },
    hello: null,
    documents: {},
    drawings: {},
    palettes: {},
    changed: {},
    notKept: "",
    marks: {},
    tests: {},
    differences: {},
    pageDifferences: {},
    showsMoved: false,
    difference: -1,
    document: "",
    page: "",
    trail: [],
    selection: [],
    dialog: "",
    placing: null,
    triggerChoice: null,
    deviceChoice: null,
    subject: "",
    shown: readShown(stored.shown, firstShown(windowWidth)),
    theme: stored.theme === "light" || stored.theme === "dark" ? stored.theme : "auto",
    notice: null,
    reveal: null,
    renaming: null,
    uses: null,
    isFinding: false,
    tour: -1,
    tourWaits: false,
    spoken: "",
  }));
  store.subscribe((state, before) => {
    if (state.shown === before.shown && state.theme === before.theme) return;
    try {
      storage.setItem(kKey, JSON.stringify({ shown: state.shown, theme: state.theme }));
    } catch {
      // A full or forbidden storage: the designer works, it only forgets.
    }
  });
  return store;
}

/** Without what was seen of a document's file. */
export function withoutChangedFile(changed: State["changed"], document: string): State["changed"] {
  const rest = { ...changed };
  delete rest[document];
  return rest;
}

/** Palette, drawing, details and one more side by side need a window so wide [px]. */
export const kWide = 1500;

/** The simulator needs room: where the window is narrow the palette makes it, for as long as the simulator is open. */
export function besideSimulator({ palette }: ShownPanes, isNarrow: boolean): Partial<ShownPanes> {
  return isNarrow && palette ? { live: true, palette: false, paletteWaits: true } : { live: true };
}

/**
 * A palette that made room comes back when what it made room for is closed, unless somebody has said otherwise meanwhile.
 * In a narrow window it makes room for the text as well, where the details stand beside that.
 */
export function shownAfter(before: ShownPanes, change: Partial<ShownPanes>, isNarrow = false): ShownPanes {
  const after = { ...before, ...change };
  if (change.palette !== undefined) after.paletteWaits = change.paletteWaits ?? false;
  else if (isNarrow && after.palette && needsRoom(before, after)) {
    return { ...after, palette: false, paletteWaits: true };
  }
  if (!after.paletteWaits || after.live || (isNarrow && after.text)) return after;
  return { ...after, palette: true, paletteWaits: false };
}

/** The simulator or the text has just been opened, and something else stands at the right as well. */
function needsRoom(before: ShownPanes, after: ShownPanes): boolean {
  const isOpened = (after.text && !before.text) || (after.live && !before.live);
  return isOpened && [after.text, after.live, after.details].filter(Boolean).length > 1;
}

/** Below, sides lie over the drawing, as in styles/narrow.css [px]. */
export const kNarrow = 900;

/** Where the sides lie over the drawing, those at the right would lie over each other: the one that opens stays. */
export function aloneAtTheRight(change: Partial<ShownPanes>): Partial<ShownPanes> {
  const opened = (["text", "live", "details"] as const).find((name) => change[name]);
  return opened ? { text: false, live: false, details: false, ...change } : change;
}

/** How many did not pass, or could not be run, the last time. */
export function failedTests(list: TestList | undefined): number {
  return (list?.tests ?? []).filter(({ state }) => state === TestList_State.FAILED || state === TestList_State.CANT_RUN)
    .length;
}

/** After a document has gone: it is not listed any more. */
export function withoutDocument({ documents, hello }: State, path: string): Partial<State> {
  const { [path]: _gone, ...others } = documents;
  return {
    documents: others,
    hello: hello && { ...hello, recent: hello.recent.filter((entry) => entry.path !== path) },
  };
}

/** A document is called otherwise: what is known of it is known under its new name. */
export function withRenamedDocument(state: State, from: string, to: string): Partial<State> {
  const moved = <T>(all: Readonly<Record<string, T>>): Record<string, T> =>
    Object.fromEntries(Object.entries(all).map(([path, one]) => [path === from ? to : path, one]));
  const drawings = Object.values(state.drawings).map((drawing): [string, Drawing] => {
    const page = drawing.page?.document === from ? { ...drawing.page, document: to } : drawing.page;
    return [pageKey(page?.document ?? "", page?.path ?? ""), page ? { ...drawing, page } : drawing];
  });
  const document = state.documents[from];
  const { documents, ...rest } = withoutDocument(state, from);
  return {
    ...rest,
    documents: document ? { ...documents, [to]: { ...document, path: to } } : documents!,
    drawings: Object.fromEntries(drawings),
    palettes: moved(state.palettes),
    tests: moved(state.tests),
    marks: moved(state.marks),
    document: state.document === from ? to : state.document,
    trail: state.trail.map((crumb) => (crumb.document === from ? { ...crumb, document: to } : crumb)),
  };
}

/** What was stored may be of another version, or anything at all: what can't be used is as at first. */
export function readShown(stored: unknown, first: ShownPanes): ShownPanes {
  if (!isRecord(stored)) return first;
  const shown = { ...first } as Record<keyof ShownPanes, boolean | number>;
  for (const name of Object.keys(first) as (keyof ShownPanes)[]) {
    const value = stored[name];
    if (typeof value !== typeof first[name]) continue;
    if (typeof value === "number") shown[name] = Math.min(1200, Math.max(160, value));
    else if (typeof value === "boolean") shown[name] = value;
  }
  return shown as unknown as ShownPanes;
}

/** The page that is shown. */
export function drawingOf(state: State): Drawing | undefined {
  return state.drawings[pageKey(state.document, state.page)];
}
