// The box in which everything is found; the sheet of shortcuts.
import { useState } from "react";
import { KeySheet } from "../../ui/commands/commands.tsx";
import { commandsFound, Everything, resultsIn, type SearchResult } from "../../ui/commands/everything.tsx";
import { score } from "../../ui/commands/search.ts";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { goToHit, helpOf, kindOfHit, useHits } from "../names/search.ts";
import { place } from "../palette/place.ts";
import type { Designer } from "../session/designer.ts";
import type { Component, Hit } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { allActions } from "./all_actions.ts";

const kMouse = {
  title: "Mouse",
  rows: [
    ["Drag from an output", "Draw a wire; let go in the open to place what it leads to"],
    ["Drag the end of a wire", "Lead it to another input, or cut it"],
    ["Alt and click on a wire", "Cut it"],
    ["Double-click", "Look inside"],
    ["Drag in the open, Shift click", "Select several"],
    ["Right or middle button, wheel", "Move the canvas"],
    ["Ctrl and wheel, pinch", "Zoom"],
  ],
} as const;

/** Everything by a few letters: what can be done, what the project has, what the library has. */
export function Commands() {
  const designer = useDesigner();
  const [query, setQuery] = useState("");
  const { hits, leftOut } = useHits(designer, query);
  const components = usePart((state) => state.palettes[state.document]?.components ?? kNone);
  const library = components.filter((one) => !one.isOwn);
  const actions = allActions(designer).filter((one) => one.id !== "commands" && !/^(nudge|push|walk)-/.test(one.id));
  return (
    <Everything
      placeholder="Commands, pages, nodes, files, components…"
      groups={(wanted) => [
        commandsFound(wanted, actions),
        wanted.trim() === "" ? [] : hits.map((hit) => hitFound(designer, hit, wanted)),
        // Those of the project itself are found there.
        resultsIn(wanted, library, helpOf, (one) => componentShown(designer, one)),
      ]}
      onQuery={setQuery}
      note={sentence(leftOut)}
      onClose={() => designer.store.setState({ dialog: "" })}
    />
  );
}

const kNone: readonly Component[] = [];

function hitFound(designer: Designer, hit: Hit, query: string): SearchResult {
  const place = hit.kind === "file" ? hit.path : `${hit.path}, line ${hit.line}`;
  return {
    id: `hit ${hit.path} ${hit.begin} ${hit.name}`,
    label: hit.name,
    detail: hit.help || place,
    group: "In this project",
    tail: kindOfHit(hit),
    icon: <Icon name={hit.kind === "file" ? "file" : "right"} />,
    // Of equal ones what the project has comes before commands.
    points: score(query, hit.name) + 1,
    run: () => goToHit(designer, hit),
  };
}

function componentShown(designer: Designer, one: Component): Omit<SearchResult, "points"> {
  return {
    id: `component ${one.name}`,
    label: one.title || one.name,
    detail: one.help,
    group: "Components",
    tail: one.group,
    icon: <Icon name="why" />,
    run: () => lookAt(designer, one),
  };
}

/** Its page, where it has one; else it is placed where that can be done, and explained where it can't. */
function lookAt(designer: Designer, { name, title, source, help }: Component): void {
  if (source.endsWith(".cdl")) void designer.navigation.open(source, name);
  else if (designer.drawing?.isReadOnly || designer.state.page === "")
    designer.tell(`${title || name}: ${help}`, "accent");
  else void place(designer, name, null);
}

export function ShortcutSheet() {
  const designer = useDesigner();
  // Of four arrows that do the same one stands for all.
  const actions = allActions(designer)
    .filter((one) => !/^(push|nudge|walk)-(right|up|down)/.test(one.id))
    .map((one) => ({ ...one, label: one.label.replace(/ left$/, " (all arrows)") }));
  return <KeySheet commands={actions} pointer={kMouse} onClose={() => designer.store.setState({ dialog: "" })} />;
}
