import { useReading } from "../session/session.ts";
import { attention } from "./checklist.ts";

/** Whether the mission has vehicles: else there is no such panel. */
export function useHasVehicles(): boolean {
  return useReading(["preflight"], (model) => model.get("preflight")?.hasVehicles ?? false);
}

/** On the panel's button. */
export function usePreflightBadge(): number {
  return useReading(["preflight"], (model) => attention(model.get("preflight")));
}
