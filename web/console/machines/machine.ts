// How a machine of the fleet is, in words: what it has said, and how old that is.
import { type Machines, type Machines_Machine, Machines_State as State } from "../../core/protocol.ts";
import { count, quantity } from "../../ui/words/format.ts";

export interface Condition {
  word: string;
  tone: "" | "go" | "danger";
  /** Nothing is heard of it: what is shown is as old as its silence. */
  isOld: boolean;
}

/** The worst first; what is not heard any more is not known any more. */
export function condition(machine: Machines_Machine): Condition {
  const heard = age(machine.heard);
  if (machine.state === State.SILENT) return { word: `Silent ${heard}`, tone: "", isOld: true };
  if (machine.state === State.GONE) return { word: `Gone, heard ${heard} ago`, tone: "", isOld: true };
  if (machine.isStopped)
    return { word: machine.notKept === "" ? "Stopped" : "Stopped, not kept", tone: "danger", isOld: false };
  return { word: "There", tone: "go", isOld: false };
}

/** `12 s`, `3 min`, `5 h`, as `mlab fleet` says it. */
export function age(seconds: number): string {
  if (seconds < 120) return `${Math.floor(seconds)} s`;
  return seconds < 7200 ? `${Math.floor(seconds / 60)} min` : `${Math.floor(seconds / 3600)} h`;
}

/** Of one that nothing is heard of there is nothing to measure. */
function unmeasured(state: State): string {
  return state === State.THERE ? "not measured yet" : "–";
}

/** `1.2 ms there and back, 5 % lost`. */
export function linkText({ link, state }: Machines_Machine): string {
  if (!link) return unmeasured(state);
  const lost = link.lost > 0 ? `, ${Math.max(1, Math.round(link.lost * 100))} % lost` : "";
  return `${(link.roundTrip * 1000).toFixed(1)} ms there and back${lost}`;
}

/** How far its clock is ahead. */
export function clockText({ link, state }: Machines_Machine): string {
  if (!link) return unmeasured(state);
  if (!link.isClockKnown) return "the same";
  const size = Math.abs(link.clockOffset);
  return `${size < 1 ? `${quantity(size * 1000, 3)} ms` : age(size)} ${link.clockOffset > 0 ? "ahead" : "behind"}`;
}

/** What it carries beside this run's robots, or for whom. */
export function othersText(machine: Machines_Machine): string {
  if (machine.vehicle !== "") return machine.vehicle;
  const others = machine.carried - machine.robots.length;
  if (others > 0) return count(others, "robot of another run", "robots of other runs");
  return machine.robots.length === 0 ? "none" : "";
}

/** `0.1.0`; and this console's own, where that is another one: such a machine carries nothing for it. */
export function versionText(machine: Machines_Machine, own: string): string {
  const offers = machine.offers === "" ? "" : `, carries ${machine.offers} only`;
  const others = machine.version === own || own === "" ? "" : `, which is not this console's ${own}`;
  return `${machine.version}${others}${offers}`;
}

/** `0.4 of 2 processors, 1830 MB free`. */
export function healthText({ load, processors, freeMemory }: Machines_Machine): string {
  return `load ${load.toFixed(1)} of ${count(processors, "processor")}, ${freeMemory >> 20n} MB free`;
}

/** Those that somebody ought to look at: silent ones, and those that have left with robots of this run. */
export function attention(machines: Machines | null): number {
  return (machines?.machines ?? []).filter(
    ({ state, robots }) => state === State.SILENT || (state === State.GONE && robots.length > 0),
  ).length;
}
