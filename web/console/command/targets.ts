// Who a command is meant for, in words.

import { idRanges } from "../../core/format.ts";
import type { Targets } from "../../core/protocol.ts";
import { count } from "../format.ts";

export interface TargetLine {
  unit: string;
  does: string;
  meant: string;
  skipped: string[];
  replaces: string;
}

export function targetLines(targets: Targets): TargetLine[] {
  return targets.units.map((unit) => ({
    unit: unit.name,
    does: unit.command,
    meant: unit.robots.length === 0 ? "no robots" : `${count(unit.robots.length, "robot")} (${idRanges(unit.robots)})`,
    skipped: bySameReason(unit.skipped),
    replaces: unit.replaces,
  }));
}

function bySameReason(skipped: readonly { robot: number; reason: string }[]): string[] {
  const robots = new Map<string, number[]>();
  for (const { robot, reason } of skipped) robots.set(reason, [...(robots.get(reason) ?? []), robot]);
  return [...robots].map(([reason, ids]) => `${ids.length === 1 ? "robot" : "robots"} ${idRanges(ids)}: ${reason}`);
}
