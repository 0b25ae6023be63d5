// What leads from one node to another: wires and transitions, drawn, moved and cut.
import type { Connection, Edge, FinalConnectionState, ReactFlowInstance } from "@xyflow/react";
import type { MouseEvent } from "react";
import { onPitch } from "../arrange/elk.ts";
import type { Designer } from "../session/designer.ts";
import { isEquipment } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { askFits, connectChange, disconnectChange, endOf, reasonAgainst, stopFits } from "../sight/wiring.ts";
import { addTransition } from "../states/trigger.ts";

/** Handlers of React Flow for what leads from one node to another. */
export function connecting(designer: Designer, drawing: Drawing, flow: ReactFlowInstance) {
  return drawing.kind === Drawing_Kind.STATES
    ? transitionGestures(designer, drawing)
    : wireGestures(designer, drawing, flow);
}

function transitionGestures(designer: Designer, drawing: Drawing) {
  return {
    onConnect: ({ source, target }: Connection) => void addTransition(designer, source, target),
    onEdgeClick: cutByClick(designer, drawing),
  };
}

function wireGestures(designer: Designer, drawing: Drawing, flow: ReactFlowInstance) {
  const page = drawing.page?.path ?? "";
  return {
    onConnect: ({ source, target, targetHandle }: Connection) =>
      void designer.edit("", connectChange(page, source, target, targetHandle ?? "")),
    onConnectStart: (_: unknown, { nodeId, handleId, handleType }: ConnectStart) => {
      if (nodeId)
        void askFits(
          designer,
          handleType === "source" ? { node: nodeId } : { to: { node: nodeId, row: handleId ?? "" } },
        );
    },
    onConnectEnd: (event: globalThis.MouseEvent | TouchEvent, end: FinalConnectionState) =>
      letGo(designer, drawing, end, flow.screenToFlowPosition(pointOf(event))),
    onReconnect: (old: Edge, next: Connection) => reconnect(designer, page, old, next),
    onReconnectEnd: (_: unknown, wire: Edge, __: unknown, end: FinalConnectionState) => {
      stopFits();
      if (drawing.isReadOnly || end.toHandle) return;
      const { node, row } = endOf(wire.id);
      void designer.edit(`disconnect ${wire.source}`, disconnectChange(page, node, row));
    },
    isValidConnection: (wire: Connection | Edge) =>
      reasonAgainst(wire.source, wire.target, wire.targetHandle ?? "") === "",
    onEdgeClick: cutByClick(designer, drawing),
  };
}

interface ConnectStart {
  nodeId: string | null;
  handleId: string | null;
  handleType: string | null;
}

/** Where nothing is the search palette offers what fits there. `at`: on the canvas. */
function letGo(designer: Designer, drawing: Drawing, end: FinalConnectionState, at: { x: number; y: number }): void {
  const reason = end.toHandle && !end.isValid ? whyNot(end) : "";
  stopFits();
  if (reason) designer.tell(reason, "hold");
  if (end.toHandle || end.toNode || !end.fromHandle || drawing.isReadOnly) return;
  const from = end.fromHandle;
  designer.store.setState({
    dialog: "place",
    placing: {
      x: onPitch(at.x),
      y: onPitch(at.y),
      ...(from.type === "source" ? { from: from.nodeId } : { to: placeFor(from.nodeId, from.id ?? "") }),
    },
  });
}

function reconnect(designer: Designer, page: string, old: Edge, { source, target, targetHandle }: Connection): void {
  const end = endOf(old.id);
  const isSameEnd = end.node === target && end.row === targetHandle;
  if (isSameEnd && old.source === source) return;
  const cut = disconnectChange(page, end.node, end.row);
  const wire = connectChange(page, source, target, targetHandle ?? "");
  // A device always serves something: it only gets another end.
  const isMoved = isSameEnd || (designer.drawing !== undefined && isEquipment(designer.drawing));
  void designer.edit(`move a wire of ${source}`, ...(isMoved ? [wire] : [cut, wire]));
}

/** With Alt. */
function cutByClick(designer: Designer, drawing: Drawing) {
  return (event: MouseEvent, wire: Edge) => {
    if (event.altKey && !drawing.isReadOnly) void cutWire(designer, drawing, wire.id);
  };
}

function cutWire(designer: Designer, drawing: Drawing, id: string) {
  const page = drawing.page?.path ?? "";
  if (drawing.kind === Drawing_Kind.STATES) {
    const at = id.lastIndexOf("/");
    return designer.edit("", {
      case: "removeTransition",
      value: { page, from: id.slice(0, at), index: Number(id.slice(at + 1)) },
    });
  }
  const { node, row } = endOf(id);
  return designer.edit("", disconnectChange(page, node, row));
}

function placeFor(node: string, row: string) {
  const found = /^(.*)\[(\d+)\]$/.exec(row);
  return found ? { node, port: found[1]!, index: Number(found[2]) } : { node, port: row };
}

function whyNot(end: FinalConnectionState): string {
  const [from, to] = [end.fromHandle, end.toHandle];
  if (!from || !to) return "";
  return from.type === "source"
    ? reasonAgainst(from.nodeId, to.nodeId, to.id ?? "")
    : reasonAgainst(to.nodeId, from.nodeId, from.id ?? "");
}

function pointOf(event: globalThis.MouseEvent | TouchEvent): { x: number; y: number } {
  const touch = "changedTouches" in event ? event.changedTouches[0] : event;
  return { x: touch?.clientX ?? 0, y: touch?.clientY ?? 0 };
}
