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
import { ghostsOf, isGhost, isGhostTransition, withGhosts, withoutGhost } from "../compare/compared.ts";
import { type CanvasNode, type CanvasWire, nodesOf, type Places, wiresOf } from "../drawing/flow.ts";
import { type Drawing, Drawing_Kind, type PageDifference } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { useCanvas } from "../sight/canvas_store.ts";
import { stateNodes, type TransitionEdge, transitionEdges, transitionId } from "../states/flow.ts";
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
export function useElements(
  drawing: Drawing,
  difference: PageDifference | undefined,
  places: Places | null,
  isDragging: RefObject<boolean>,
): Elements {
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
    const whole = withGhosts(drawing, difference);
    setNodes((before) =>
      (isStates
        ? stateNodes(whole, places, before)
        : [...nodesOf(drawing, places, before as CanvasNode[]), ...ghostNodes(drawing, difference, places)]
      )
        .map((node) => asGhost(node as FlowNode))
        .map((node) => withLabel(node as FlowNode))
        .map((node) => marked(node, selection)),
    );
    setEdges((before) =>
      isStates
        ? transitionEdges(whole, places, before, scale).map((edge) => asGhostEdge(edge, drawing))
        : [...wiresOf(drawing, before as CanvasWire[]), ...ghostWires(drawing, difference)],
    );
  }, [drawing, difference, places, isStates, designer, scale, isDragging]);

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
  const found = useCanvas((state) => state.found);
  return {
    nodes: useMemo(() => withFound(nodes, found), [nodes, found]),
    edges: useMemo(() => withFound(edges, found), [edges, found]),
    ids,
    nodesChange,
    edgesChange,
  };
}

/** What was found on the page is marked. */
function withFound<T extends { id: string; className?: string }>(items: T[], found: ReadonlySet<string>): T[] {
  if (found.size === 0) return items;
  return items.map((item) =>
    found.has(item.id) ? { ...item, className: item.className ? `${item.className} found` : "found" } : item,
  );
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

/** What has gone is looked at, and no more. */
const kOnlySeen = { draggable: false, selectable: false, focusable: false, deletable: false, connectable: false };

function asGhost(node: FlowNode): FlowNode {
  if (!isGhost(node.id) || node.selectable === false) return node;
  return { ...node, ...kOnlySeen, ariaLabel: `${withoutGhost(node.id)}, removed` };
}

function ghostNodes(drawing: Drawing, difference: PageDifference | undefined, places: Places): FlowNode[] {
  const ghosts = ghostsOf(drawing, difference);
  return ghosts ? nodesOf(ghosts, places, []).filter((node) => node.type === "node") : [];
}

function ghostWires(drawing: Drawing, difference: PageDifference | undefined): Edge[] {
  const ghosts = ghostsOf(drawing, difference);
  if (!ghosts) return [];
  const whole = { ...ghosts, nodes: [...drawing.nodes, ...ghosts.nodes] };
  return wiresOf(whole, []).map((wire) => ({
    ...wire,
    id: `-${wire.id}`,
    selectable: false,
    deletable: false,
    reconnectable: false,
  }));
}

/** How many are asked is counted without those that have gone. */
function asGhostEdge(edge: TransitionEdge, drawing: Drawing): TransitionEdge {
  const { transition } = edge.data!;
  if (isGhostTransition(transition))
    return { ...edge, data: { ...edge.data!, siblings: 1 }, selectable: false, deletable: false, reconnectable: false };
  const siblings = drawing.transitions.filter((one) => one.from === transition.from).length;
  return siblings === edge.data!.siblings ? edge : { ...edge, data: { ...edge.data!, siblings } };
}
