// A page of states as what the canvas shows.
import type { Edge, Node as FlowNode } from "@xyflow/react";
import { Position } from "@xyflow/react";
import type { Places } from "../canvas/flow.ts";
import type { Drawing, State, Transition } from "../protocol.ts";
import { bendsOf } from "./bends.ts";
import { type Curve, curveBetween, loopAt, type Rect } from "./curve.ts";
import { stateSize } from "./form.ts";

export interface StateData extends Record<string, unknown> {
  state: State;
  page: string;
  isReadOnly: boolean;
}
export interface TransitionData extends Record<string, unknown> {
  transition: Transition;
  /** As bendsOf says. */
  bend: number;
  /** How many the state it leaves has: the order matters where there are several. */
  siblings: number;
  page: string;
}
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

export function transitionEdges(drawing: Drawing, places: Places, before: readonly { id: string }[]): TransitionEdge[] {
  const known = new Map(before.map((one) => [one.id, one as TransitionEdge]));
  const bends = transitionBends(drawing, places);
  const page = drawing.page?.path ?? "";
  const names = new Set(drawing.states.map((state) => state.name));
  return drawing.transitions.flatMap((transition, i) => {
    if (!names.has(transition.from) || !names.has(transition.to)) return [];
    const siblings = drawing.transitions.filter((one) => one.from === transition.from).length;
    return [
      {
        id: transitionId(transition),
        type: "transition" as const,
        source: transition.from,
        sourceHandle: "out",
        target: transition.to,
        targetHandle: "in",
        data: { transition, bend: bends[i]!, siblings, page },
        selected: known.get(transitionId(transition))?.selected ?? false,
      },
    ];
  });
}

export function transitionBends(drawing: Drawing, places: Places): number[] {
  const rects = new Map<string, Rect>();
  for (const state of drawing.states) {
    const at = places.get(state.name);
    if (at) rects.set(state.name, { ...at, ...stateSize(state) });
  }
  return bendsOf(
    drawing.transitions.map(({ from, to, trigger }) => ({
      from,
      to,
      labelWidth: Math.min(240, 44 + trigger.length * 6.7),
    })),
    rects,
  );
}

/** The way of a transition between where the two states are. */
export function curveOf(data: TransitionData, from: Rect, to: Rect): Curve {
  const { transition, bend } = data;
  if (transition.from === transition.to) return loopAt(from, bend);
  return curveBetween(from, to, bend, transition.from > transition.to);
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
