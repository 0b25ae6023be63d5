// A page of states as what the canvas shows.
import type { Edge, Node as FlowNode } from "@xyflow/react";
import { Position } from "@xyflow/react";
import type { Places } from "../drawing/flow.ts";
import type { Drawing, State, Transition } from "../session/protocol.ts";
import { type Curve, curveBetween, loopAt, type Rect } from "./curve.ts";
import { stateSize } from "./form.ts";
import { kScales, labelLines, labelSize } from "./label.ts";
import { type LabelSizes, type Route, Router } from "./routes.ts";

export interface StateData extends Record<string, unknown> {
  state: State;
  page: string;
  isReadOnly: boolean;
}
export interface TransitionData extends Record<string, unknown> {
  transition: Transition;
  route: Route;
  /** What is written on its label. */
  lines: readonly string[];
  /** How many times larger than usual, as seen from far away. */
  scale: number;
  /** How many the state it leaves has: the order matters where there are several. */
  siblings: number;
  page: string;
}
/** Of more of them, labels are as large as they are: there is no room for larger ones, and looking for it takes long. */
const kManyTransitions = 150;
/** Labels as large as they are must find room; larger ones only may. Of more transitions each restart takes too long. */
const restartsFor = (scale: number, transitions: number) => (scale === 1 && transitions <= 40 ? 12 : 0);

export type StateNode = FlowNode<StateData, "state">;
export type TransitionEdge = Edge<TransitionData, "transition">;

export function transitionId({ from, index }: { from: string; index: number }): string {
  return `${from}/${index}`;
}

/** The transition of an id of the selection. */
export function transitionOf(drawing: Drawing, id: string): Transition | undefined {
  return drawing.transitions.find((one) => transitionId(one) === id);
}

export function stateNodes(drawing: Drawing, places: Places, before: readonly { id: string }[]): StateNode[] {
  const known = new Map(before.map((one) => [one.id, one as StateNode]));
  const page = drawing.page?.path ?? "";
  return drawing.states.flatMap((state) => {
    const at = places.get(state.name);
    if (!at) return [];
    const old = known.get(state.name);
    const size = stateSize(state);
    const isSame = old?.type === "state" && isSameState(old.data.state, state) && old.data.page === page;
    if (isSame && old.position.x === at.x && old.position.y === at.y && old.width === size.width) return [old];
    const rim = { ...size, x: 0, y: 0 };
    return [
      {
        id: state.name,
        type: "state" as const,
        position: { x: at.x, y: at.y },
        data: isSame ? old.data : { state, page, isReadOnly: drawing.isReadOnly },
        ...size,
        measured: size,
        handles: [
          { id: "in", type: "target" as const, position: Position.Left, ...rim },
          {
            id: "out",
            type: "source" as const,
            position: Position.Right,
            x: size.width - 9,
            y: size.height / 2 - 9,
            width: 18,
            height: 18,
          },
        ],
        draggable: !drawing.isReadOnly,
        selected: old?.selected ?? false,
      },
    ];
  });
}

export function transitionEdges(
  drawing: Drawing,
  places: Places,
  before: readonly { id: string }[],
  wanted = 1,
): TransitionEdge[] {
  const known = new Map(before.map((one) => [one.id, one as TransitionEdge]));
  const { routes, scale } = transitionRoutes(drawing, places, wanted);
  const page = drawing.page?.path ?? "";
  const names = new Set(drawing.states.map((state) => state.name));
  return drawing.transitions.flatMap((transition, i) => {
    if (!names.has(transition.from) || !names.has(transition.to)) return [];
    const route = routes[i]!;
    const lines = labelLines(transition.trigger, route.isShort);
    return [
      {
        id: transitionId(transition),
        type: "transition" as const,
        source: transition.from,
        sourceHandle: "out",
        target: transition.to,
        targetHandle: "in",
        data: { transition, route, lines, scale, siblings: siblingsOf(drawing, transition), page },
        selected: known.get(transitionId(transition))?.selected ?? false,
      },
    ];
  });
}

function siblingsOf(drawing: Drawing, { from }: Transition): number {
  return drawing.transitions.filter((one) => one.from === from).length;
}

/**
 * How every transition goes, and where its label stands: as large as `wanted`, or as large as there is room for.
 */
export function transitionRoutes(drawing: Drawing, places: Places, wanted = 1): { routes: Route[]; scale: number } {
  const rects = new Map<string, Rect>();
  for (const state of drawing.states) {
    const at = places.get(state.name);
    if (at) rects.set(state.name, { ...at, ...stateSize(state) });
  }
  const router = new Router(drawing.transitions, rects);
  let best: { routes: Route[]; scale: number; trouble: number } | undefined;
  const isMany = drawing.transitions.length > kManyTransitions;
  for (const scale of kScales.filter((one) => one <= wanted && (one === 1 || !isMany))) {
    const labels = drawing.transitions.map((transition) => labelsOf(drawing, transition, scale));
    const found = router.run(labels, restartsFor(scale, labels.length));
    if (!best || found.trouble < best.trouble) best = { ...found, scale };
    if (best.trouble === 0) break;
  }
  return best ?? { routes: [], scale: 1 };
}

function labelsOf(drawing: Drawing, transition: Transition, scale: number): LabelSizes {
  const { trigger } = transition;
  const marks = labelMarks(transition, siblingsOf(drawing, transition));
  const [label, short] = [false, true].map((isShort) => labelSize(labelLines(trigger, isShort), marks, scale));
  return { label: label!, short: short! };
}

/** How many signs stand beside the trigger: its number where there are several, the arrow of those that start anew. */
export function labelMarks(transition: Transition, siblings: number): number {
  return (siblings > 1 ? 1 : 0) + (transition.restarts ? 1 : 0);
}

/** The way of a transition between where the two states are. */
export function curveOf(transition: Transition, route: Route, from: Rect, to: Rect): Curve {
  if (transition.from === transition.to) return loopAt(from, route.bend);
  return curveBetween(from, to, route.bend, transition.from > transition.to);
}

function isSameState(a: State, b: State): boolean {
  return (
    a.name === b.name &&
    a.isStart === b.isStart &&
    a.isFinal === b.isFinal &&
    a.member === b.member &&
    a.title === b.title &&
    a.help === b.help &&
    a.live === b.live &&
    a.inner?.path === b.inner?.path &&
    a.calls?.path === b.calls?.path
  );
}
