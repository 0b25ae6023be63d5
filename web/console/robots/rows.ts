// Units and robots as one list: a unit, its own robots, then the units in it.
import type { RosterIndex } from "../../core/roster.ts";
import type { Selection } from "../../core/selection.ts";
import { kNothing, selectRobots, selectUnit } from "../../core/selection.ts";

export type RosterRow =
  | { key: string; kind: "unit"; name: string; depth: number; robots: readonly number[] }
  | { key: string; kind: "robot"; id: number; name: string; depth: number; unit: string };

/** What the query finds is shown with the units above it; all of a unit that is found itself. */
export function rosterRows(roster: RosterIndex, query: string, folded: ReadonlySet<string>): RosterRow[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = (text: string) => words.every((word) => text.toLowerCase().includes(word));
  const rows: RosterRow[] = [];
  const placed = new Set<number>();
  const robotRow = (id: number, depth: number, unit: string): RosterRow => ({
    key: `r:${id}`,
    kind: "robot",
    id,
    name: roster.nameOf(id),
    depth,
    unit,
  });
  const children = new Map<number, number[]>();
  roster.units.forEach((unit, index) => {
    children.set(unit.parent, [...(children.get(unit.parent) ?? []), index]);
  });
  const addUnit = (index: number, depth: number, isFound: boolean): boolean => {
    const unit = roster.units[index];
    if (!unit) return false;
    const at = rows.length;
    const all = roster.robotsOf(unit.name);
    const found = isFound || (words.length > 0 && fits(unit.name));
    rows.push({ key: `u:${unit.name}`, kind: "unit", name: unit.name, depth, robots: all });
    const inside = children.get(index) ?? [];
    const below = new Set(inside.flatMap((child) => [...roster.robotsOf(roster.units[child]?.name ?? "")]));
    let any = found || words.length === 0;
    const isFolded = folded.has(unit.name) && words.length === 0;
    for (const id of all) {
      if (below.has(id)) continue;
      placed.add(id);
      if (isFolded || !(found || words.length === 0 || fits(`${roster.nameOf(id)} ${roster.robot(id)?.type ?? ""}`)))
        continue;
      rows.push(robotRow(id, depth + 1, unit.name));
      any = true;
    }
    for (const id of below) placed.add(id);
    if (!isFolded) for (const child of inside) any = addUnit(child, depth + 1, found) || any;
    if (!any) rows.length = at;
    return any;
  };
  for (const top of children.get(-1) ?? []) addUnit(top, 0, false);
  for (const robot of roster.robots) {
    if (!placed.has(robot.id) && fits(`${roster.nameOf(robot.id)} ${robot.type}`)) rows.push(robotRow(robot.id, 0, ""));
  }
  return rows;
}

/** The rows that a selection marks. */
export function selectedKeys(selection: Selection): string[] {
  return selection.unit ? [`u:${selection.unit}`] : selection.robots.map((id) => `r:${id}`);
}

/** One unit alone is selected as such; anything else as robots. */
export function selectionOf(keys: readonly string[], roster: RosterIndex): Selection {
  const units = keys.filter((key) => key.startsWith("u:")).map((key) => key.slice(2));
  const robots = keys.filter((key) => key.startsWith("r:")).map((key) => Number(key.slice(2)));
  if (units.length === 0 && robots.length === 0) return kNothing;
  const [unit] = units;
  if (unit !== undefined && units.length === 1 && robots.length === 0) return selectUnit(unit, roster.robotsOf(unit));
  return selectRobots([...units.flatMap((name) => [...roster.robotsOf(name)]), ...robots]);
}
