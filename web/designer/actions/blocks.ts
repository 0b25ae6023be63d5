// Why something can't be done now, as a sentence; nothing: it can.
import type { Designer } from "../session/designer.ts";
import { Drawing_Kind } from "../session/protocol.ts";
import { selectionByKind } from "./editing.ts";

const kWithoutComponents: ReadonlySet<Drawing_Kind> = new Set([
  Drawing_Kind.FILE,
  Drawing_Kind.SOCIETY,
  Drawing_Kind.CLASS,
  Drawing_Kind.OPERATOR,
  Drawing_Kind.BINDING,
]);

export const kClosed = "Open a configuration first";

export interface Blocks {
  /** No page is shown. */
  readonly closed: string | undefined;
  /** Or it can't be changed. */
  readonly fixed: string | undefined;
  /** Or nothing can be placed on it. */
  readonly noPlace: string | undefined;
  readonly noSelection: string | undefined;
  readonly noNode: string | undefined;
  /** Of several nodes, or none, it can't be said which is meant. */
  readonly notOneNode: string | undefined;
}

export function blocksOf(designer: Designer): Blocks {
  const { document, drawing, state } = designer;
  const { nodes } = selectionByKind(designer);
  const closed = drawing ? undefined : kClosed;
  const isReadOnly = drawing?.isReadOnly || document?.isReadOnly;
  const fixed = closed ?? (isReadOnly ? "This can't be changed: make a copy of your own" : undefined);
  const isFile = drawing !== undefined && kWithoutComponents.has(drawing.kind);
  return {
    closed,
    fixed,
    noPlace: fixed ?? (isFile ? "No component stands on this page: what it takes is at the left" : undefined),
    noSelection: state.selection.length === 0 ? "Nothing is selected" : undefined,
    noNode: nodes.length === 0 ? "No node is selected" : undefined,
    notOneNode: nodes.length === 1 ? undefined : "Select one node",
  };
}
