// What stands on the canvas: the drawing's nodes and wires as React Flow holds them.
import {
  applyEdgeChanges,
  applyNodeChanges,
  type Edge,
  type EdgeChange,
  type Node as FlowNode,
  type NodeChange,
} from "@xyflow/react";
import { type RefObject, useEffect, useMemo, useState } from "react";
import { withGhosts } from "../compare/compared.ts";
import { type CanvasNode, type CanvasWire, nodesOf, type Places, wiresOf } from "../drawing/flow.ts";
import { type Drawing, Drawing_Kind, type PageDifference } from "../session/protocol.ts";
import { useDesigner } from "../session/use.ts";
import { useCanvas } from "../sight/canvas_store.ts";
import { stateNodes, transitionEdges } from "../states/flow.ts";
import { spokenNode } from "../views/node_view.tsx";
import { spokenState } from "../views/state_view.tsx";
import { asGhost, asGhostEdge, ghostNodes, ghostWires } from "./ghosts.ts";
import { allAsSelected, asSelected } from "./selected.ts";
import type { Selecting } from "./selecting.ts";

export interface Elements {
  readonly nodes: FlowNode[];
  readonly edges: Edge[];
  readonly onNodesChange: (changes: NodeChange[]) => void;
  readonly onEdgesChange: (changes: EdgeChange[]) => void;
}

/** What is drawn. */
interface Page {
  readonly drawing: Drawing;
  readonly difference: PageDifference | undefined;
}

/** `isMoving`: nodes stay where the hand has them. */
export function useElements(
  { drawing, difference }: Page,
  places: Places | null,
  { selection, select }: Selecting,
  isMoving: RefObject<boolean>,
): Elements {
  const designer = useDesigner();
  const scale = useCanvas((state) => state.scale);
  const [nodes, setNodes] = useState<FlowNode[]>([]);
  const [edges, setEdges] = useState<Edge[]>([]);

  useEffect(() => {
    if (!places || isMoving.current) return;
    const page = { drawing, difference };
    const chosen = new Set(designer.state.selection);
    setNodes((before) => drawnNodes(page, places, before).map((node) => asSelected(withLabel(asGhost(node)), chosen)));
    setEdges((before) => drawnEdges(page, places, before, scale));
  }, [drawing, difference, places, designer, scale, isMoving]);

  // What is selected elsewhere (a problem, a link, the details) is selected here.
  useEffect(() => {
    const wanted = new Set(selection);
    setNodes((before) => allAsSelected(before, wanted));
    setEdges((before) => allAsSelected(before, wanted));
  }, [selection]);

  const found = useCanvas((state) => state.found);
  return {
    nodes: useMemo(() => withFound(nodes, found), [nodes, found]),
    edges: useMemo(() => withFound(edges, found), [edges, found]),
    onNodesChange: (changes) => {
      select(changes);
      setNodes((before) => applyNodeChanges(changes, before));
    },
    onEdgesChange: (changes) => {
      select(changes);
      setEdges((before) => applyEdgeChanges(changes, before));
    },
  };
}

function drawnNodes({ drawing, difference }: Page, places: Places, before: FlowNode[]): FlowNode[] {
  if (drawing.kind === Drawing_Kind.STATES) return stateNodes(withGhosts(drawing, difference), places, before);
  return [...nodesOf(drawing, places, before as CanvasNode[]), ...ghostNodes(drawing, difference, places)];
}

function drawnEdges({ drawing, difference }: Page, places: Places, before: Edge[], scale: number): Edge[] {
  if (drawing.kind !== Drawing_Kind.STATES)
    return [...wiresOf(drawing, before as CanvasWire[]), ...ghostWires(drawing, difference)];
  const whole = withGhosts(drawing, difference);
  return transitionEdges(whole, places, before, scale).map((edge) => asGhostEdge(edge, drawing));
}

/** What was found on the page is marked. */
function withFound<T extends { id: string; className?: string }>(items: T[], found: ReadonlySet<string>): T[] {
  if (found.size === 0) return items;
  return items.map((item) =>
    found.has(item.id) ? { ...item, className: item.className ? `${item.className} found` : "found" } : item,
  );
}

function withLabel(node: FlowNode): FlowNode {
  if (node.ariaLabel) return node;
  const data = node.data as Record<string, never>;
  const label =
    node.type === "node"
      ? spokenNode(data.node!)
      : node.type === "state"
        ? spokenState(data.state!)
        : node.type === "result"
          ? "Result of the page"
          : "Comment";
  return { ...node, ariaLabel: label };
}
