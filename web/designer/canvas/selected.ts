// What is selected, after what was done on the canvas. Pure.
import type { EdgeChange, NodeChange } from "@xyflow/react";

/** What React Flow tells of a click, a frame drawn round things, a click in the open: what was chosen stays in its order. */
export function selectionAfter(
  before: readonly string[],
  changes: readonly (NodeChange | EdgeChange)[],
): readonly string[] {
  const told = changes.filter((change) => change.type === "select");
  if (told.length === 0) return before;
  const after = new Set(before);
  for (const { id, selected } of told) {
    if (selected) after.add(id);
    else after.delete(id);
  }
  return [...after];
}

/** Without what is no longer there. */
export function stillThere(selection: readonly string[], ids: ReadonlySet<string>): readonly string[] {
  return selection.every((id) => ids.has(id)) ? selection : selection.filter((id) => ids.has(id));
}

interface Selectable {
  id: string;
  selected?: boolean;
}

function isMarked({ id, selected = false }: Selectable, wanted: ReadonlySet<string>): boolean {
  return selected === wanted.has(id);
}

/** The same object where it is selected, or not, already. */
export function asSelected<T extends Selectable>(item: T, wanted: ReadonlySet<string>): T {
  return isMarked(item, wanted) ? item : { ...item, selected: wanted.has(item.id) };
}

/** The same list where nothing in it changes. */
export function allAsSelected<T extends Selectable>(items: T[], wanted: ReadonlySet<string>): T[] {
  return items.every((item) => isMarked(item, wanted)) ? items : items.map((item) => asSelected(item, wanted));
}
