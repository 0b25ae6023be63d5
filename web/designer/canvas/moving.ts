// Nodes moved by hand: while they are, they stay where the hand has them; then the configuration says where they stand.
import type { Node as FlowNode, ReactFlowProps } from "@xyflow/react";
import { type RefObject, useRef } from "react";
import { arrangeChange } from "../arrange/arrange.ts";
import type { Places } from "../drawing/flow.ts";
import type { Designer } from "../session/designer.ts";
import type { Drawing } from "../session/protocol.ts";
import { useDesigner } from "../session/use.ts";
import { forgetMoved, isArranged, keepMoved } from "../sight/use_places.ts";

type Handlers = "onNodeDragStart" | "onNodeDragStop" | "onSelectionDragStart" | "onSelectionDragStop";

export interface Moving {
  readonly isMoving: RefObject<boolean>;
  /** Of React Flow; a node that was not drawn by then is none of the moved ones. */
  readonly handlers: (drawn: readonly FlowNode[]) => Pick<ReactFlowProps, Handlers>;
}

export function useMoving(drawing: Drawing, places: Places | null): Moving {
  const designer = useDesigner();
  const isMoving = useRef(false);
  const begin = () => {
    isMoving.current = true;
  };
  return {
    isMoving,
    handlers: (drawn) => {
      const end = (_: unknown, moved: readonly FlowNode[]) => {
        isMoving.current = false;
        const known = moved.filter(({ id }) => drawn.some((node) => node.id === id));
        if (moved.length > 0 && !drawing.isReadOnly) moveNodes(designer, drawing, known, places ?? new Map());
      };
      return {
        onNodeDragStart: begin,
        onNodeDragStop: (event, _, moved) => end(event, moved),
        onSelectionDragStart: begin,
        onSelectionDragStop: end,
      };
    },
  };
}

function moveNodes(designer: Designer, drawing: Drawing, moved: readonly FlowNode[], places: Places): void {
  const { changes, places: now } = arrangeChange(drawing, moved, places, isArranged(drawing));
  keepMoved(drawing, now);
  const name = moved.length === 1 ? `move ${moved[0]!.id}` : `move ${moved.length} nodes`;
  void designer.edit(name, ...changes).then((answer) => !answer.ok && forgetMoved(drawing));
}
