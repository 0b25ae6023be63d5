// Delete takes away what is selected on the map, whichever tool is held.

import { removeItems } from "../map_editing/edit_map.ts";
import { elsewhen } from "../session/elsewhen.ts";
import type { Action } from "../session/registry.ts";
import type { Session } from "../session/session.ts";

export function removeActions(session: Session): readonly Action[] {
  const { items } = session.model.get("selection");
  const blocked = !session.model.mayOrder()
    ? (elsewhen(session.model) ?? "Only the operator can change the map.")
    : items.length === 0
      ? "Nothing of the map is selected."
      : undefined;
  return [
    {
      id: "remove-things",
      label: items.length > 1 ? `Remove ${items.length} things of the map` : "Remove what is selected on the map",
      group: "Edit",
      shortcut: "delete",
      blocked,
      run: () => void removeItems(session, items),
    },
  ];
}
