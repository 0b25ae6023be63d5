// Units and robots as one list: a unit, its own robots, then the units in it.
import type { RosterIndex } from "../../core/roster.ts";
import type { Selection } from "../../core/selection.ts";
import { kNothing, selectRobots, selectUnit } from "../../core/selection.ts";

export type RosterRow =
  | { key: string; kind: "unit"; name: string; depth: number; robots: readonly number[] }
  | { key: string; kind: "robot"; id: number; name: string; depth: number; unit: string };

/** What the query finds is shown with the units above it; all of a unit that is found itself. */
export function rosterRows(roster: RosterIndex, query: string, folded: ReadonlySet<string>): RosterRow[] {
  return new Rows(roster, query, folded).all();
}

class Rows {
  private readonly words: readonly string[];
  private readonly rows: RosterRow[] = [];
  /** Robots that stand in a unit, shown or not. */
  private readonly placed = new Set<number>();
  private readonly children = new Map<number, number[]>();

  constructor(
    private readonly roster: RosterIndex,
    query: string,
    private readonly folded: ReadonlySet<string>,
  ) {
    this.words = query.toLowerCase().split(/\s+/).filter(Boolean);
    roster.units.forEach((unit, index) => {
      this.children.set(unit.parent, [...(this.children.get(unit.parent) ?? []), index]);
    });
  }

  all(): RosterRow[] {
    for (const top of this.children.get(-1) ?? []) this.addUnit(top, 0, false);
    for (const { id } of this.roster.robots) {
      if (!this.placed.has(id) && this.fitsRobot(id)) this.addRobot(id, 0, "");
    }
    return this.rows;
  }

  /** `isFound`: a unit around it was. @returns whether anything of it is shown */
  private addUnit(index: number, depth: number, isFound: boolean): boolean {
    const unit = this.roster.units[index];
    if (!unit) return false;
    const at = this.rows.length;
    const robots = this.roster.robotsOf(unit.name);
    const isAll = this.words.length === 0;
    const isWhole = isFound || isAll || this.fits(unit.name);
    const isFolded = isAll && this.folded.has(unit.name);
    this.rows.push({ key: `u:${unit.name}`, kind: "unit", name: unit.name, depth, robots });
    const inside = this.children.get(index) ?? [];
    const below = new Set(inside.flatMap((child) => [...this.roster.robotsOf(this.roster.units[child]?.name ?? "")]));
    const own = robots.filter((id) => !below.has(id));
    for (const id of robots) this.placed.add(id);
    const shown = isFolded ? [] : own.filter((id) => isWhole || this.fitsRobot(id));
    for (const id of shown) this.addRobot(id, depth + 1, unit.name);
    let any = isWhole || shown.length > 0;
    if (!isFolded) for (const child of inside) any = this.addUnit(child, depth + 1, isWhole && !isAll) || any;
    if (!any) this.rows.length = at;
    return any;
  }

  private addRobot(id: number, depth: number, unit: string): void {
    this.rows.push({ key: `r:${id}`, kind: "robot", id, name: this.roster.nameOf(id), depth, unit });
  }

  private fitsRobot(id: number): boolean {
    return this.fits(`${this.roster.nameOf(id)} ${this.roster.robot(id)?.type ?? ""}`);
  }

  private fits(text: string): boolean {
    return this.words.every((word) => text.toLowerCase().includes(word));
  }
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
