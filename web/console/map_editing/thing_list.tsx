// A list with search whose choice is the selection of the map, and the reverse.
import { type KeyboardEvent, useMemo, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import type { MapItem } from "../../core/selection.ts";
import { Search } from "../../ui/controls/controls.tsx";
import { usePart, useSession } from "../session/session.ts";
import { removeItems } from "./edit_map.ts";
import "./world.css";

export interface ListedThing {
  readonly item: MapItem;
  readonly title: string;
  readonly detail: string;
  readonly isEditable: boolean;
}

interface Props {
  label: string;
  things: readonly ListedThing[];
  /** Arrow keys with Alt move what is chosen. */
  onNudge?: (event: KeyboardEvent) => boolean;
}

const kMostShown = 200; // search reaches the others

export function ThingList({ label, things, onNudge }: Props) {
  const session = useSession();
  const { items } = usePart("selection");
  const [query, setQuery] = useState("");
  const found = useMemo(() => {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    return things.filter((t) => words.every((w) => `${t.title} ${t.detail}`.toLowerCase().includes(w)));
  }, [things, query]);
  const chosen = items.map(keyOf);
  const shown = [
    ...found.slice(0, kMostShown),
    ...found.slice(kMostShown).filter((t) => chosen.includes(keyOf(t.item))),
  ];
  const keys = (event: KeyboardEvent) => {
    if (event.target instanceof HTMLInputElement) return;
    if (event.key === "Delete" || event.key === "Backspace") {
      event.preventDefault();
      void removeItems(session, session.model.get("selection").items);
    } else if (event.altKey && onNudge?.(event)) {
      event.preventDefault();
      event.stopPropagation();
    }
  };
  return (
    <div className="thing-list" onKeyDownCapture={keys}>
      {things.length > 8 && <Search label={`Search ${label.toLowerCase()}`} value={query} onChange={setQuery} />}
      <ListBox
        aria-label={label}
        className="thing-rows"
        items={shown.map((t) => ({ ...t, id: keyOf(t.item) }))}
        selectionMode="multiple"
        selectionBehavior="replace"
        selectedKeys={chosen}
        onSelectionChange={(keys) => {
          const wanted = keys === "all" ? shown : shown.filter((t) => keys.has(keyOf(t.item)));
          session.model.select({ robots: [], unit: "", items: wanted.map((t) => t.item) });
        }}
        onAction={() => session.ui.get("map")?.framing.fitSelection()}
        renderEmptyState={() => <span className="muted small">{query ? "Nothing of that name." : "None yet."}</span>}
      >
        {(thing) => (
          <ListBoxItem className="thing-row" textValue={thing.title}>
            <span className="ellipsis">{thing.title}</span>
            <span className="small muted ellipsis">{thing.detail}</span>
          </ListBoxItem>
        )}
      </ListBox>
      {found.length > shown.length && (
        <span className="help">… and {found.length - shown.length} more: search for them.</span>
      )}
    </div>
  );
}

function keyOf({ kind, index }: MapItem): string {
  return `${kind}/${index}`;
}
