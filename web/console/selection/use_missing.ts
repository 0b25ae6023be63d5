// What is told where nothing is known of a robot but its place.
import { useReading } from "../session/session.ts";

export function useMissing(): string {
  const isOnlyRecorded = useReading(["timeLine"], (model) => (model.get("timeLine")?.onlyRecorded ?? "") !== "");
  return isOnlyRecorded ? "Where it was is all that was recorded of it." : "Waiting for its data…";
}
