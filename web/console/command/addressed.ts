// Whom a command is for that is given by mouse: what is selected, and nobody else.

interface UnitMembers {
  readonly name: string;
  /** Of the units in it, too. */
  readonly robots: readonly number[];
}

export interface Addressees {
  readonly units: readonly string[];
  /** Robots that are a unit for as long as the order lasts; none where units are meant. */
  readonly robots: readonly number[];
  /** What a person should do first. Empty: nothing. */
  readonly note: string;
}

/**
 * The unit that was selected; else the largest units that make up the selection; else just the selected robots. With
 * nothing selected the only unit that is in no other.
 */
export function addressedUnits(
  selection: { readonly unit: string; readonly robots: readonly number[] },
  units: readonly UnitMembers[],
): Addressees {
  if (selection.unit !== "") return { units: [selection.unit], robots: [], note: "" };
  if (selection.robots.length === 0) return onlyUnit(units);
  const left = new Set(selection.robots);
  const result: string[] = [];
  const bySize = [...units].sort((a, b) => b.robots.length - a.robots.length);
  for (const unit of bySize) {
    if (unit.robots.length === 0 || !unit.robots.every((id) => left.has(id))) continue;
    result.push(unit.name);
    for (const id of unit.robots) left.delete(id);
  }
  if (left.size === 0) return { units: result, robots: [], note: "" };
  return { units: [], robots: [...new Set(selection.robots)].sort((a, b) => a - b), note: "" };
}

function onlyUnit(units: readonly UnitMembers[]): Addressees {
  const all = new Set(units.flatMap((u) => u.robots));
  const whole = units.filter((u) => u.robots.length === all.size && all.size > 0);
  const first = whole[0];
  return first
    ? { units: [first.name], robots: [], note: "" }
    : { units: [], robots: [], note: "Select a unit or robots to command them." };
}
