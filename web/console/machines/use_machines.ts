import { useReading } from "../session/session.ts";
import { attention } from "./machine.ts";

/** Whether a fleet carries the run's robots: else there is no such panel. */
export function useHasMachines(): boolean {
  return useReading(["machines"], (model) => model.get("machines") !== null);
}

/** On the panel's button. */
export function useMachinesBadge(): number {
  return useReading(["machines"], (model) => attention(model.get("machines")));
}
