// Who a command is meant for, in words.

import { idRanges } from "../../core/format.ts";
import { Targets_Standing_Fate as Fate, type Targets } from "../../core/protocol.ts";
import { count } from "../../ui/words/format.ts";

export interface TargetLine {
  unit: string;
  does: string;
  meant: string;
  skipped: string[];
}

/** What becomes of a unit that is not meant, or of the command that robots are taken from. */
export interface StandingLine {
  unit: string;
  fate: string;
  /** The command changes or ends. */
  isTouched: boolean;
}

export function targetLines(targets: Targets): TargetLine[] {
  return targets.units.map((unit) => ({
    unit: unit.name,
    does: unit.command,
    meant: unit.robots.length === 0 ? "no robots" : `${count(unit.robots.length, "robot")} (${idRanges(unit.robots)})`,
    skipped: bySameReason(unit.skipped),
  }));
}

/** What ends or changes first; units without any command in one line. */
export function standingLines(targets: Targets): StandingLine[] {
  const lines: StandingLine[] = [];
  const idle: string[] = [];
  for (const { unit, command, fate, leaving, staying } of targets.standing) {
    const gone = `${leaving.length === 1 ? "robot" : "robots"} ${idRanges(leaving)}`;
    if (fate === Fate.IDLE) idle.push(unit);
    else if (fate === Fate.ENDS) lines.push({ unit, fate: `ends ${command}`, isTouched: true });
    else if (fate === Fate.GOES_ON_WITHOUT)
      lines.push({ unit, fate: `goes on with ${command} without ${gone}, ${staying} left`, isTouched: true });
    else lines.push({ unit, fate: `goes on with ${command}`, isTouched: false });
  }
  lines.sort((a, b) => Number(b.isTouched) - Number(a.isTouched));
  if (idle.length > 0) {
    const named = idle.slice(0, kNamedIdle).join(", ");
    const more = idle.length > kNamedIdle ? ` and ${idle.length - kNamedIdle} more` : "";
    lines.push({ unit: `${named}${more}`, fate: "no command before or after", isTouched: false });
  }
  return lines;
}

const kNamedIdle = 8;

function bySameReason(skipped: readonly { robot: number; reason: string }[]): string[] {
  const robots = new Map<string, number[]>();
  for (const { robot, reason } of skipped) robots.set(reason, [...(robots.get(reason) ?? []), robot]);
  return [...robots].map(([reason, ids]) => `${ids.length === 1 ? "robot" : "robots"} ${idRanges(ids)}: ${reason}`);
}
