// One undo over two histories: edits of the mission live in the server, which numbers them; edits of how the map looks
// live here. Such an edit remembers the newest mission edit before it, so that the two interleave as they happened.

export interface LocalEdit<State> {
  name: string;
  before: State;
  after: State;
  /** Number of the mission edit that was the newest when this one was made; 0: none. */
  since: bigint;
}

export interface LocalHistory<State> {
  done: readonly LocalEdit<State>[];
  undone: readonly LocalEdit<State>[]; // the last one is redone first
}

/** As the server tells it. */
export interface MissionEdits {
  undo: string;
  redo: string;
  undoNumber: bigint;
  redoNumber: bigint;
}

export type Next<State> = { kind: "mission"; name: string } | { kind: "local"; edit: LocalEdit<State> } | undefined;

const kMostEdits = 200;

export function emptyHistory<State>(): LocalHistory<State> {
  return { done: [], undone: [] };
}

export function recordEdit<State>(history: LocalHistory<State>, edit: LocalEdit<State>): LocalHistory<State> {
  return { done: [...history.done, edit].slice(-kMostEdits), undone: [] };
}

/** What Undo would undo: the newer of the two newest edits. */
export function nextUndo<State>(history: LocalHistory<State>, mission: MissionEdits): Next<State> {
  const edit = history.done.at(-1);
  if (edit && (mission.undo === "" || edit.since >= mission.undoNumber)) return { kind: "local", edit };
  return mission.undo === "" ? undefined : { kind: "mission", name: mission.undo };
}

/** What Redo would redo: the older of the two. */
export function nextRedo<State>(history: LocalHistory<State>, mission: MissionEdits): Next<State> {
  const edit = history.undone.at(-1);
  if (edit && (mission.redo === "" || edit.since < mission.redoNumber)) return { kind: "local", edit };
  return mission.redo === "" ? undefined : { kind: "mission", name: mission.redo };
}

export function undoLocal<State>(history: LocalHistory<State>): LocalHistory<State> {
  const edit = history.done.at(-1);
  return edit ? { done: history.done.slice(0, -1), undone: [...history.undone, edit] } : history;
}

export function redoLocal<State>(history: LocalHistory<State>): LocalHistory<State> {
  const edit = history.undone.at(-1);
  return edit ? { done: [...history.done, edit], undone: history.undone.slice(0, -1) } : history;
}

export function nameOf<State>(next: Next<State>): string {
  if (!next) return "";
  return next.kind === "mission" ? next.name : next.edit.name;
}
