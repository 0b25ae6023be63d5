// What the page knows of running beside what the simulator tells: what was tried, and how it shall look.
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Point } from "../../core/geometry.ts";
import type { MapView } from "../../core/map/map_view.ts";
import type { FieldArrow } from "./field_arrows.ts";

/** What was last handed to the simulator from this page. */
export interface LastTrial {
  readonly document: string;
  readonly revision: bigint;
  /** What was asked for, as `setupKey` says it. */
  readonly setup: string;
  /** Path of the mission among the simulator's documents. */
  readonly mission: string;
  /** What was assumed, sentences. */
  readonly notes: readonly string[];
}

/** A place of a drawing: `id` as in State.selection. */
export interface DrawnAt {
  readonly document: string;
  readonly page: string;
  readonly id: string;
  /** It is not in the drawing any more; page and id are the last that were known. */
  readonly isLost: boolean;
}

/** A value that stays in sight whatever page is shown. */
export interface Pin extends DrawnAt {
  /** Port.path. */
  readonly port: string;
  /** Mark.id. */
  readonly mark: number;
}

export interface Field {
  readonly arrows: readonly FieldArrow[];
  /** [m] between arrows. */
  readonly pitch: number;
  /** What was assumed. */
  readonly note: string;
  /** Of what: a node of the page, or its result. */
  readonly title: string;
}

export interface LiveState {
  isBusy: boolean;
  /** Why the last attempt did not run; empty: it did. */
  error: string;
  /** What became of robots that took over the last change; empty: none did. */
  takenOver: string;
  tried: LastTrial | null;
  /** What runs: a declaration's name; empty: found by the page. */
  subject: string;
  robots: number;
  /** Path; empty: an open field. */
  overlay: string;
  starts: readonly Point[];
  /** Places where the page runs: paths, of the selected robot's program. */
  places: readonly string[];
  /** Of them, whose values are shown; empty: none is known. */
  place: string;
  chosenPlace: string;
  pins: readonly Pin[];
  /** Where breakpoints that were set on a drawing are drawn, by their ids. */
  drawnAt: ReadonlyMap<number, DrawnAt>;
  /** The map of the pane, while it is shown. */
  map: MapView | null;
  /** The pointer sets start places. */
  isPlacing: boolean;
  /** The movement field is shown, and read anew while time stands still. */
  showsField: boolean;
  field: Field | null;
  /** Why there is no field. */
  fieldError: string;
  /** What the fields of a node's inputs change while it runs. */
  changes: "robots" | "text";
}

/** What runs, how many, where: the same words for the same run. */
export function setupKey(name: string, { robots, overlay, starts }: Pick<LiveState, "robots" | "overlay" | "starts">) {
  return JSON.stringify([name, robots, overlay, starts]);
}

export type LiveStore = StoreApi<LiveState>;

export const kMostRobots = 100;

export function createLiveState(): LiveStore {
  return createStore<LiveState>(() => ({
    isBusy: false,
    error: "",
    takenOver: "",
    tried: null,
    subject: "",
    robots: 3,
    overlay: "",
    starts: [],
    places: [],
    place: "",
    chosenPlace: "",
    pins: [],
    drawnAt: new Map(),
    map: null,
    isPlacing: false,
    showsField: false,
    field: null,
    fieldError: "",
    changes: "robots",
  }));
}
