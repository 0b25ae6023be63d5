import type { Log_Entry } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import type { Session } from "../session/session.ts";

/** Where it happened, else where the robot or unit is now. */
export function showPlace({ model, ui }: Session, entry: Pick<Log_Entry, "robot" | "unit" | "place">): void {
  const map = ui.get("map");
  const roster = model.get("roster");
  if (entry.robot !== 0 && roster.robot(entry.robot)) model.select(selectRobots([entry.robot]));
  const robots = entry.robot !== 0 ? [entry.robot] : roster.robotsOf(entry.unit);
  const place = entry.place ?? robots.map((id) => model.placeOf(id)).find((found) => found !== undefined);
  if (place) map?.framing.centreOn(place);
}

export function hasPlace(entry: Pick<Log_Entry, "robot" | "unit" | "place">): boolean {
  return entry.place !== undefined || entry.robot !== 0 || entry.unit !== "";
}
