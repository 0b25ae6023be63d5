import { type Status, Status_Outcome } from "../../core/protocol.ts";
import { splitCommand } from "./steps.ts";

/** What the unit is doing now, without its name; empty: nothing. */
export function commandOfUnit(status: Status | null, unit: string): string {
  for (const step of [...(status?.steps ?? [])].reverse()) {
    for (const command of step.commands) {
      if (command.unit === unit && command.outcome === Status_Outcome.UNDER_WAY)
        return splitCommand(command.text).order;
    }
  }
  return "";
}
