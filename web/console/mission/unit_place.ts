import { selectRobots, selectUnit } from "../../core/selection.ts";
import type { Session } from "../session/session.ts";

/** Selects the units' robots and brings them into view. */
export function unitPlace({ model, ui }: Session, units: readonly string[]): void {
  const roster = model.get("roster");
  const named = [...new Set(units)].filter((unit) => unit !== "");
  const robots = named.flatMap((unit) => roster.robotsOf(unit));
  if (robots.length === 0) return;
  model.select(
    named.length === 1 ? selectUnit(named[0] as string, roster.robotsOf(named[0] as string)) : selectRobots(robots),
  );
  ui.get("map")?.framing.fitSelection();
}

/** Selects one robot and brings it into view. */
export function robotPlace({ model, ui }: Session, robot: number): void {
  model.select(selectRobots([robot]));
  ui.get("map")?.framing.fitSelection();
}
