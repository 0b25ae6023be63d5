// What of the log is shown.
import { type Log_Entry, Log_Kind } from "../../core/protocol.ts";

export const kKindWords: Record<Log_Kind, string> = {
  [Log_Kind.STEP]: "Step",
  [Log_Kind.COMMAND]: "Command",
  [Log_Kind.MESSAGE]: "Message",
  [Log_Kind.WARNING]: "Warning",
  [Log_Kind.OPERATOR]: "Operator",
  [Log_Kind.CONTACT]: "Contact",
  [Log_Kind.STUCK]: "Stuck",
  [Log_Kind.LOST]: "Lost",
  [Log_Kind.STATE]: "State",
  [Log_Kind.EDIT]: "Edit",
  [Log_Kind.MISSION]: "Mission",
  [Log_Kind.ANSWER]: "Answer",
  [Log_Kind.BREAKPOINT]: "Breakpoint",
};

export const kKinds = Object.keys(kKindWords).map(Number) as Log_Kind[];

export interface LogFilter {
  text: string;
  /** Kinds that are left out. */
  hidden: ReadonlySet<Log_Kind>;
  /** Only of these robots; empty: of all. */
  robots: ReadonlySet<number>;
  unit: string;
}

export const kEverything: LogFilter = { text: "", hidden: new Set(), robots: new Set(), unit: "" };

/** Words may stand in any order in text, kind, unit or `robot 3`. */
export function filterLog(log: readonly Log_Entry[], filter: LogFilter): Log_Entry[] {
  const words = filter.text.toLowerCase().split(/\s+/).filter(Boolean);
  const unit = filter.unit.toLowerCase();
  return log.filter((entry) => {
    if (filter.hidden.has(entry.kind)) return false;
    if (filter.robots.size > 0 && !filter.robots.has(entry.robot)) return false;
    if (unit !== "" && entry.unit.toLowerCase() !== unit) return false;
    if (words.length === 0) return true;
    const searched =
      `${entry.text} ${kKindWords[entry.kind]} ${entry.unit} ${entry.robot ? `robot ${entry.robot}` : ""}`.toLowerCase();
    return words.every((word) => searched.includes(word));
  });
}

/** Which rows of equal height a scrolled window shows, with a few beyond its edges. */
export function windowOf(
  total: number,
  scrollTop: number,
  height: number,
  rowHeight: number,
): { first: number; end: number } {
  const first = Math.max(0, Math.floor(scrollTop / rowHeight) - 6);
  return { first: Math.min(first, total), end: Math.min(total, Math.ceil((scrollTop + height) / rowHeight) + 6) };
}
