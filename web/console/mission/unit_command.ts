import { type Status, type Status_Command, Status_Outcome } from "../../core/protocol.ts";
import { count } from "../../ui/words/format.ts";
import { splitCommand } from "./steps.ts";

/** What the unit is doing now, without its name, or what it will when it need not wait any more; empty: nothing. */
export function commandOfUnit(status: Status | null, unit: string): string {
  const underWay = [...(status?.steps ?? [])]
    .reverse()
    .flatMap(({ commands }) => commands)
    .filter((command) => command.unit === unit && command.outcome === Status_Outcome.UNDER_WAY);
  const command = underWay.find(({ isHeld }) => !isHeld) ?? underWay[0];
  return command ? shown(command) : "";
}

function shown(command: Status_Command): string {
  const { order } = splitCommand(command.text);
  if (command.isHeld) return `${order} waits for ${command.waitsFor}`;
  const left = command.followers.length;
  return left > 0 ? `${order}, ${count(left, "robot")} left` : order;
}

export interface Followed {
  /** Whom the command names. */
  readonly unit: string;
  readonly order: string;
}

/** Which command under way each robot follows. */
export function followedBy(
  status: Status | null,
  robotsOf: (unit: string) => readonly number[],
): ReadonlyMap<number, Followed> {
  const result = new Map<number, Followed>();
  for (const step of status?.steps ?? []) {
    for (const command of step.commands) {
      if (command.outcome !== Status_Outcome.UNDER_WAY || command.isHeld || command.unit === "") continue;
      const followed = { unit: command.unit, order: splitCommand(command.text).order };
      const robots = command.followers.length > 0 ? command.followers : robotsOf(command.unit);
      for (const id of robots) result.set(id, followed);
    }
  }
  return result;
}

/** Whether all robots follow the same as before. */
export function isSameFollowing(a: ReadonlyMap<number, Followed>, b: ReadonlyMap<number, Followed>): boolean {
  if (a.size !== b.size) return false;
  for (const [id, { unit, order }] of a) {
    const other = b.get(id);
    if (other?.unit !== unit || other.order !== order) return false;
  }
  return true;
}
