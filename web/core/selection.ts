// What is selected, on the map and in the lists alike.

/** A thing of the Scene, by its index there. */
export interface MapItem {
  readonly kind: "measure" | "obstacle" | "object";
  readonly index: number;
}

export interface Selection {
  /** In the order in which they were chosen; the first is the one whose panel is shown. */
  readonly robots: readonly number[];
  /** The unit that was chosen as a whole; empty: robots were chosen one by one. */
  readonly unit: string;
  readonly items: readonly MapItem[];
}

export const kNothing: Selection = { robots: [], unit: "", items: [] };

export function selectRobots(robots: readonly number[]): Selection {
  return robots.length ? { ...kNothing, robots: [...new Set(robots)] } : kNothing;
}

export function selectUnit(unit: string, robots: readonly number[]): Selection {
  return { ...kNothing, unit, robots };
}

export function selectItem(item: MapItem): Selection {
  return { ...kNothing, items: [item] };
}

/** As a click with shift does: in, or out where it was in. */
export function toggleRobot(selection: Selection, robot: number): Selection {
  const robots = selection.robots.includes(robot)
    ? selection.robots.filter((id) => id !== robot)
    : [...selection.robots, robot];
  return { ...selection, robots, unit: "" };
}

export function toggleItem(selection: Selection, item: MapItem): Selection {
  const others = selection.items.filter((other) => other.kind !== item.kind || other.index !== item.index);
  return { ...selection, items: others.length < selection.items.length ? others : [...others, item] };
}
