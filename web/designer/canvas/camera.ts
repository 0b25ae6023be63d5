// What of the page is in sight: all of it when it is opened, until somebody moves the camera.
import { type Node as FlowNode, useReactFlow, useStore } from "@xyflow/react";
import { useEffect, useRef, useState } from "react";
import { isEmptyDrawing } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner } from "../session/use.ts";
import { canvasStore, distanceAt } from "../sight/canvas_store.ts";
import { fitReadably, kFit, setView } from "../sight/view.ts";
import { scaleAt } from "../states/label.ts";

const kPaneSize = 60; // no pane takes less than twice of it, no line more [px]

export interface Camera {
  /** The page has been brought into sight. */
  readonly isInSight: boolean;
  readonly moved: (view: { x: number; y: number; zoom: number }, isByHand: boolean) => void;
}

export function useCamera(drawing: Drawing, nodes: readonly FlowNode[]): Camera {
  const designer = useDesigner();
  const flow = useReactFlow();
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const fittedKind = useRef<Drawing_Kind | null>(null);
  const [isInSight, setInSight] = useState(false);

  // Once, when the page has come into sight or become one of states; later only where somebody asks for it.
  useEffect(() => {
    // On an empty page the camera stays where the first thing is put.
    if (isEmptyDrawing(drawing)) {
      fittedKind.current = drawing.kind;
      setInSight(true);
    }
    if (fittedKind.current === drawing.kind || nodes.length === 0) return;
    if (nodes.some((node) => node.type === "state") !== isStates) return; // still those of before
    fittedKind.current = drawing.kind;
    const only = designer.state.selection.map((id) => ({ id }));
    const fitted = only.length > 0 && nodes.length > 40 ? flow.fitView({ ...kFit, nodes: only }) : fitReadably(flow);
    void fitted.then(() => setInSight(true));
  }, [nodes, flow, designer, drawing, isStates]);

  useEffect(() => setView(flow), [flow]);

  const isFitted = useRef(true);
  useRefitting(() => isFitted.current && fittedKind.current !== null && nodes.length > 0);
  const moved: Camera["moved"] = (view, isByHand) => {
    if (isByHand) isFitted.current = false;
    noteView(view, nodes.length);
  };
  return { isInSight, moved };
}

/**
 * A pane that opens beside the canvas takes of its place: who has not moved the camera goes on seeing everything. A line
 * that comes and goes above it moves nothing.
 */
function useRefitting(isWanted: () => boolean): void {
  const flow = useReactFlow();
  const width = useStore((state) => Math.round(state.width / kPaneSize));
  const height = useStore((state) => Math.round(state.height / kPaneSize));
  const sizeBefore = useRef({ width: 0, height: 0 });
  const wanted = useRef(isWanted);
  wanted.current = isWanted;
  useEffect(() => {
    const before = sizeBefore.current;
    if (Math.abs(width - before.width) < 2 && Math.abs(height - before.height) < 2) return;
    sizeBefore.current = { width, height };
    if (before.width > 0 && wanted.current()) void fitReadably(flow);
  }, [width, height, flow]);
}

function noteView({ x, y, zoom }: { x: number; y: number; zoom: number }, nodes: number): void {
  const element = document.querySelector(".canvas");
  const { width = 800, height = 600 } = element?.getBoundingClientRect() ?? {};
  const distance = distanceAt(zoom, nodes);
  canvasStore.setState({
    distance,
    scale: scaleAt(zoom),
    view: { x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom },
  });
}
