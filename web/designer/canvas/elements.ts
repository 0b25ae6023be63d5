// What stands on the canvas: the drawing's nodes and wires as React Flow holds them, and which of them are selected.
import {
  applyEdgeChanges,
  applyNodeChanges,
  type Edge,
  type EdgeChange,
  type Node as FlowNode,
  type NodeChange,
} from "@xyflow/react";
import { type RefObject, useEffect, useMemo, useState } from "react";
import { type CanvasNode, type CanvasWire, nodesOf, type Places, wiresOf } from "../drawing/flow.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { useCanvas } from "../sight/canvas_store.ts";
import { stateNodes, transitionEdges, transitionId } from "../states/flow.ts";
import { spokenNode } from "../views/node_view.tsx";
import { spokenState } from "../views/state_view.tsx";
import { selectionAfter, stillThere } from "./selected.ts";

export interface Elements {
  readonly nodes: FlowNode[];
  readonly edges: Edge[];
  /** Everything on the page that can be selected. */
  readonly ids: ReadonlySet<string>;
  readonly nodesChange: (changes: NodeChange[]) => void;
  readonly edgesChange: (changes: EdgeChange[]) => void;
}

/** `isDragging`: nodes stay where the hand has them. */
export function useElements(drawing: Drawing, places: Places | null, isDragging: RefObject<boolean>): Elements {
  const designer = useDesigner();
  const scale = useCanvas((state) => state.scale);
  const [nodes, setNodes] = useState<FlowNode[]>([]);
  const [edges, setEdges] = useState<Edge[]>([]);
  const isStates = drawing.kind === Drawing_Kind.STATES;

  // What the drawing has no more is not selected any more: undone, renamed, put into an assemblage.
  const ids = useMemo(() => selectable(drawing), [drawing]);
  useEffect(() => designer.select(stillThere(designer.state.selection, ids)), [ids, designer]);

  useEffect(() => {
    if (!places || isDragging.current) return;
    const selection = new Set(designer.state.selection);
    setNodes((before) =>
      (isStates ? stateNodes(drawing, places, before) : nodesOf(drawing, places, before as CanvasNode[]))
        .map((node) => withLabel(node as FlowNode))
        .map((node) => marked(node, selection)),
    );
    setEdges((before) =>
      isStates ? transitionEdges(drawing, places, before, scale) : wiresOf(drawing, before as CanvasWire[]),
    );
  }, [drawing, places, isStates, designer, scale, isDragging]);

  // What is selected elsewhere (a problem, a link, the details) is selected here.
  const selection = usePart((state) => state.selection);
  useEffect(() => {
    const wanted = new Set(selection);
    setNodes((before) => allMarked(before, wanted));
    setEdges((before) => allMarked(before, wanted));
  }, [selection]);

  const select = (changes: (NodeChange | EdgeChange)[]) =>
    designer.select(stillThere(selectionAfter(designer.state.selection, changes), ids));
  const nodesChange = (changes: NodeChange[]) => {
    select(changes);
    setNodes((before) => applyNodeChanges(changes, before));
  };
  const edgesChange = (changes: EdgeChange[]) => {
    select(changes);
    setEdges((before) => applyEdgeChanges(changes, before));
  };
  return { nodes, edges, ids, nodesChange, edgesChange };
}

interface Selectable {
  id: string;
  selected?: boolean;
}

function isMarked({ id, selected = false }: Selectable, wanted: ReadonlySet<string>): boolean {
  return selected === wanted.has(id);
}

/** The same object where it is selected, or not, already. */
function marked<T extends Selectable>(item: T, wanted: ReadonlySet<string>): T {
  return isMarked(item, wanted) ? item : { ...item, selected: wanted.has(item.id) };
}

function allMarked<T extends Selectable>(items: T[], wanted: ReadonlySet<string>): T[] {
  return items.every((item) => isMarked(item, wanted)) ? items : items.map((item) => marked(item, wanted));
}

/** Everything on the page that can be selected. */
function selectable(drawing: Drawing): ReadonlySet<string> {
  const { nodes, states, notes } = drawing;
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const wires = isStates ? drawing.transitions.map(transitionId) : wiresOf(drawing, []).map((wire) => wire.id);
  return new Set([...[...nodes, ...states].map((one) => one.name), ...notes.map((note) => note.id), ...wires]);
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
