// To which units a command goes that is given by mouse: commands of MDL are for units, people select robots too.

interface UnitMembers {
  readonly name: string;
  /** Of the units in it, too. */
  readonly robots: readonly number[];
}

export interface Addressed {
  readonly units: readonly string[];
  /** What a person should know: robots that are meant beside the selected ones. Empty: nothing. */
  readonly note: string;
}

/**
 * The unit that was selected; else the largest units all of whose robots are selected; robots beyond these stand for the
 * smallest unit that they are in. With nothing selected the only unit that is in no other.
 */
export function addressedUnits(
  selection: { readonly unit: string; readonly robots: readonly number[] },
  units: readonly UnitMembers[],
): Addressed {
  if (selection.unit !== "") return { units: [selection.unit], note: "" };
  if (selection.robots.length === 0) return onlyUnit(units);
  const left = new Set(selection.robots);
  const result: string[] = [];
  const bySize = [...units].sort((a, b) => b.robots.length - a.robots.length);
  for (const unit of bySize) {
    if (unit.robots.length === 0 || !unit.robots.every((id) => left.has(id))) continue;
    result.push(unit.name);
    for (const id of unit.robots) left.delete(id);
  }
  const added: string[] = [];
  const homeless: number[] = [];
  for (const id of left) {
    const home = bySize.findLast((unit) => unit.robots.includes(id));
    if (!home) homeless.push(id);
    else if (!result.includes(home.name)) {
      result.push(home.name);
      added.push(home.name);
    }
  }
  const notes: string[] = [];
  if (added.length > 0) notes.push(`Commands go to units: all of ${added.join(" and ")} is meant.`);
  if (homeless.length > 0) notes.push(`Robot ${homeless.join(", ")} is in no unit with a name and can’t be commanded.`);
  return { units: result, note: notes.join(" ") };
}

function onlyUnit(units: readonly UnitMembers[]): Addressed {
  const all = new Set(units.flatMap((u) => u.robots));
  const whole = units.filter((u) => u.robots.length === all.size && all.size > 0);
  const first = whole[0];
  return first
    ? { units: [first.name], note: "" }
    : { units: [], note: "Select a unit, or robots of one, to command it." };
}
