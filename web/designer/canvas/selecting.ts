// The selection on the canvas: what is chosen by hand, and what is chosen elsewhere.
import type { EdgeChange, NodeChange } from "@xyflow/react";
import { useEffect, useMemo } from "react";
import { wiresOf } from "../drawing/flow.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { transitionId } from "../states/flow.ts";
import { selectionAfter, stillThere } from "./selected.ts";

export interface Selecting {
  /** Everything on the page that can be selected. */
  readonly ids: ReadonlySet<string>;
  readonly selection: readonly string[];
  /** What React Flow tells of. */
  readonly select: (changes: readonly (NodeChange | EdgeChange)[]) => void;
}

export function useSelecting(drawing: Drawing): Selecting {
  const designer = useDesigner();
  const selection = usePart((state) => state.selection);
  const ids = useMemo(() => selectable(drawing), [drawing]);
  // What the drawing has no more is not selected any more: undone, renamed, put into an assemblage.
  useEffect(() => designer.select(stillThere(designer.state.selection, ids)), [ids, designer]);
  const select = (changes: readonly (NodeChange | EdgeChange)[]) =>
    designer.select(stillThere(selectionAfter(designer.state.selection, changes), ids));
  return { ids, selection, select };
}

function selectable(drawing: Drawing): ReadonlySet<string> {
  const { nodes, states, notes } = drawing;
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const wires = isStates ? drawing.transitions.map(transitionId) : wiresOf(drawing, []).map((wire) => wire.id);
  return new Set([...[...nodes, ...states].map((one) => one.name), ...notes.map((note) => note.id), ...wires]);
}
