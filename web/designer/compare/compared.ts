// What differs from another version, as the canvas shows it: marks on what is there, and what has gone where it stood.
import { pageKey } from "../session/pages.ts";
import {
  DifferenceKind,
  type Differences,
  type Differences_Entry,
  type Drawing,
  type PageDifference,
  type PageDifference_Mark,
  type Transition,
  type Wire,
} from "../session/protocol.ts";
import type { State } from "../session/state.ts";
import { usePart } from "../session/use.ts";

/** Transitions that have gone count from here. */
export const kFirstGone = 1000;

/** Whether it is the name or the id of something that has gone. */
export function isGhost(id: string): boolean {
  return id.startsWith("-") || Number(id.split("/").at(-1)) >= kFirstGone;
}

/** What it was called. */
export function withoutGhost(name: string): string {
  return name.replace(/^-/, "");
}

export function isGhostTransition({ index }: Transition): boolean {
  return index >= kFirstGone;
}

/** What the document that is shown is compared with; nothing: it is not. */
export function comparedWith(state: State): Differences | undefined {
  const all = state.differences[state.document];
  return all?.title ? all : undefined;
}

/** Of the page that is shown. */
export function pageDifference(state: State): PageDifference | undefined {
  return comparedWith(state) && state.pageDifferences[pageKey(state.document, state.page)];
}

export function isMove({ kind }: { kind: DifferenceKind }): boolean {
  return kind === DifferenceKind.MOVED;
}

/** What is told: what was only moved where somebody asks for it. */
export function entriesOf(state: State): readonly Differences_Entry[] {
  const entries = comparedWith(state)?.entries ?? [];
  return state.showsMoved ? entries : entries.filter((entry) => !isMove(entry) && entry.thing !== "note");
}

/** What became of a node, a state or a transition of the page that is shown. */
export function useMark(name: string): PageDifference_Mark | undefined {
  return usePart((state) => {
    const marks = pageDifference(state)?.marks.filter((one) => one.name === name) ?? [];
    return marks.find((one) => !isMove(one)) ?? (state.showsMoved ? marks[0] : undefined);
  });
}

/** How many differences stand on a page and the pages in it. */
export function useCount(page: string | undefined): number {
  return usePart((state) => {
    if (!page || !comparedWith(state)) return 0;
    return entriesOf(state).filter((one) => one.page === page || one.page.startsWith(`${page}.`)).length;
  });
}

export function useIsNewWire(wire: Wire | undefined): boolean {
  return usePart(
    (state) =>
      wire !== undefined &&
      (pageDifference(state)?.addedWires.some(
        (one) => one.from === wire.from && one.to === wire.to && one.port === wire.port && one.index === wire.index,
      ) ??
        false),
  );
}

/** The drawing with all that has gone: for laying it out, and for what leads from state to state. */
export function withGhosts(drawing: Drawing, difference: PageDifference | undefined): Drawing {
  const isSame = difference?.page?.path === drawing.page?.path && difference?.page?.document === drawing.page?.document;
  if (!difference || !isSame) return drawing;
  const { nodes, states, transitions, wires } = difference;
  if (nodes.length + states.length + transitions.length + wires.length === 0) return drawing;
  // What is drawn still has the form that it has, so only wires to what has gone count for it.
  const toGhosts = wires.filter((wire) => isGhost(wire.to));
  return {
    ...drawing,
    nodes: [...drawing.nodes, ...nodes],
    states: [...drawing.states, ...states],
    transitions: [...drawing.transitions, ...transitions],
    wires: [...drawing.wires, ...toGhosts],
  };
}

/** Only what has gone, with all its wires; those lead to inputs that are there. */
export function ghostsOf(drawing: Drawing, difference: PageDifference | undefined): Drawing | undefined {
  if (!difference || withGhosts(drawing, difference) === drawing) return undefined;
  return {
    ...drawing,
    nodes: difference.nodes,
    notes: [],
    resultNode: "",
    resultType: "",
    wires: difference.wires.map((wire) => toThere(wire, drawing)),
    isReadOnly: true,
  };
}

/** A list may be shorter by now: then the wire led to where one more can be led. */
function toThere(wire: Wire, drawing: Drawing): Wire {
  const inputs = drawing.nodes.find((node) => node.name === wire.to)?.inputs.filter((one) => one.name === wire.port);
  if (!inputs || inputs.length === 0 || inputs.some((one) => one.index === wire.index)) return wire;
  const { index: _gone, ...rest } = wire;
  const open = inputs.find((one) => one.isList) ?? inputs[0]!;
  return open.index === undefined ? rest : { ...rest, index: open.index };
}

const kWords: Record<DifferenceKind, string> = {
  [DifferenceKind.CHANGED]: "changed",
  [DifferenceKind.ADDED]: "added",
  [DifferenceKind.REMOVED]: "removed",
  [DifferenceKind.RENAMED]: "renamed",
  [DifferenceKind.MOVED]: "moved",
};
const kSigns: Record<DifferenceKind, string> = {
  [DifferenceKind.CHANGED]: "~",
  [DifferenceKind.ADDED]: "+",
  [DifferenceKind.REMOVED]: "−",
  [DifferenceKind.RENAMED]: "~",
  [DifferenceKind.MOVED]: "›",
};

export function kindWord(kind: DifferenceKind): string {
  return kWords[kind];
}
export function kindSign(kind: DifferenceKind): string {
  return kSigns[kind];
}

/** `persistence 12 s → 6 s` */
export function detailWords({ what, before, after }: { what: string; before: string; after: string }): string {
  return `${what} ${shown(before)} → ${shown(after)}`;
}
function shown(text: string): string {
  return text === "" ? "nothing" : text.replace(/^\$|^value\./, "");
}
