// Conditions to begin with: of the robot that is selected.
import { exampleConditions } from "../../core/moment_finder.ts";
import { usePart } from "../session/session.ts";

export function useExamples(): (readonly [string, string])[] {
  const roster = usePart("roster");
  const robot = usePart("selection").robots[0] ?? roster.robots[0]?.id ?? 1;
  const state = usePart("details").get(robot)?.states[0]?.split(".").at(-1) ?? "";
  return exampleConditions(robot, state);
}
