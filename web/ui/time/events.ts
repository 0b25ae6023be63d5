// What happened in a run, by kinds that are told apart on its time line.
import { type Log_Entry, Log_Kind } from "../../core/protocol.ts";

export type EventKind =
  | "step"
  | "question"
  | "contact"
  | "warning"
  | "breakpoint"
  | "person"
  | "state"
  | "message"
  | "bookmark";

export interface TimeEvent {
  readonly time: number; // [s]
  readonly kind: EventKind;
  readonly text: string;
}

/** How a kind is drawn: apart by shape and height, not by colour alone. */
export interface EventLook {
  readonly kind: EventKind;
  /** As in `Steps`. */
  readonly name: string;
  readonly shape: "bar" | "diamond" | "down" | "up" | "circle" | "square" | "low" | "dot" | "ribbon";
  /** Middle of the sign, as a share of the line's height from above. */
  readonly height: number;
  readonly light: string;
  readonly dark: string;
}

/** What is drawn last lies on top. */
export const kLooks: readonly EventLook[] = [
  { kind: "message", name: "Messages", shape: "dot", height: 0.62, light: "#5e6878", dark: "#98a3b3" },
  { kind: "state", name: "States", shape: "low", height: 0.86, light: "#6a4bc4", dark: "#b197fc" },
  { kind: "person", name: "What people did", shape: "square", height: 0.62, light: "#0b7285", dark: "#4fd1e0" },
  { kind: "step", name: "Steps", shape: "bar", height: 0.5, light: "#1d5fc4", dark: "#74a8ff" },
  { kind: "warning", name: "Warnings", shape: "up", height: 0.4, light: "#8a6d00", dark: "#e3c34e" },
  { kind: "contact", name: "Contacts and stuck", shape: "down", height: 0.18, light: "#c01f1f", dark: "#ff7b72" },
  {
    kind: "question",
    name: "Questions and answers",
    shape: "diamond",
    height: 0.18,
    light: "#b4540a",
    dark: "#ff9f5a",
  },
  { kind: "breakpoint", name: "Breakpoints", shape: "circle", height: 0.4, light: "#a3195b", dark: "#ff85b8" },
  { kind: "bookmark", name: "Bookmarks", shape: "ribbon", height: 0.24, light: "#17692f", dark: "#5fd98a" },
];

export const kEventKinds: readonly EventKind[] = kLooks.map(({ kind }) => kind);

const kKindOf: Record<Log_Kind, EventKind> = {
  [Log_Kind.STEP]: "step",
  [Log_Kind.COMMAND]: "step",
  [Log_Kind.MISSION]: "step",
  [Log_Kind.MESSAGE]: "message",
  [Log_Kind.WARNING]: "warning",
  [Log_Kind.LOST]: "warning",
  [Log_Kind.OPERATOR]: "person",
  [Log_Kind.EDIT]: "person",
  [Log_Kind.CONTACT]: "contact",
  [Log_Kind.STUCK]: "contact",
  [Log_Kind.STATE]: "state",
  [Log_Kind.ANSWER]: "question",
  [Log_Kind.BREAKPOINT]: "breakpoint",
};

/** The log tells what was asked as it tells other messages. */
function kindOf(kind: Log_Kind, text: string): EventKind {
  if (kind === Log_Kind.MESSAGE && text.endsWith("?")) return "question";
  return kKindOf[kind] ?? "message";
}

/** Of the run alone: entries up to `after` are of an earlier one. Ordered by time. */
export function eventsOf(log: readonly Log_Entry[], after: bigint): TimeEvent[] {
  const events: TimeEvent[] = [];
  let isOrdered = true;
  for (const { number, time, kind, text } of log) {
    if (number <= after) continue;
    isOrdered &&= events.length === 0 || events.at(-1)!.time <= time;
    events.push({ time, kind: kindOf(kind, text), text });
  }
  return isOrdered ? events : events.sort((a, b) => a.time - b.time);
}

/** Moments that people have marked, among what happened. Both are ordered by time. */
export function withBookmarks(
  events: readonly TimeEvent[],
  bookmarks: readonly { readonly time: number; readonly note: string }[],
): readonly TimeEvent[] {
  if (bookmarks.length === 0) return events;
  const out: TimeEvent[] = [];
  let at = 0;
  for (const { time, note } of bookmarks) {
    while (at < events.length && events[at]!.time <= time) out.push(events[at++]!);
    out.push({ time, kind: "bookmark", text: note });
  }
  return out.concat(events.slice(at));
}

export function shownEvents(events: readonly TimeEvent[], hidden: ReadonlySet<EventKind>): readonly TimeEvent[] {
  return hidden.size === 0 ? events : events.filter(({ kind }) => !hidden.has(kind));
}

/** The first at or after a moment, by its place in the ordered list; its length where there is none. */
export function firstFrom(events: readonly { readonly time: number }[], time: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle]!.time < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The nearest one, not farther than `within` [s]. */
export function nearestEvent<Event extends { readonly time: number }>(
  events: readonly Event[],
  time: number,
  within: number,
): Event | undefined {
  const at = firstFrom(events, time);
  const near = [events[at - 1], events[at]].filter(
    (one): one is Event => one !== undefined && Math.abs(one.time - time) <= within,
  );
  return near.sort((a, b) => Math.abs(a.time - time) - Math.abs(b.time - time))[0];
}
