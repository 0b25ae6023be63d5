// What has gone since another version, where it stood: to be looked at, and no more.
import type { Edge, Node as FlowNode } from "@xyflow/react";
import { ghostsOf, isGhost, isGhostTransition, withoutGhost } from "../compare/compared.ts";
import { nodesOf, type Places, wiresOf } from "../drawing/flow.ts";
import type { Drawing, PageDifference } from "../session/protocol.ts";
import type { TransitionEdge } from "../states/flow.ts";

const kOnlySeen = { draggable: false, selectable: false, focusable: false, deletable: false, connectable: false };

export function asGhost(node: FlowNode): FlowNode {
  if (!isGhost(node.id) || node.selectable === false) return node;
  return { ...node, ...kOnlySeen, ariaLabel: `${withoutGhost(node.id)}, removed` };
}

export function ghostNodes(drawing: Drawing, difference: PageDifference | undefined, places: Places): FlowNode[] {
  const ghosts = ghostsOf(drawing, difference);
  return ghosts ? nodesOf(ghosts, places, []).filter((node) => node.type === "node") : [];
}

export function ghostWires(drawing: Drawing, difference: PageDifference | undefined): Edge[] {
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

/** How many transitions a state has is counted without those that have gone. */
export function asGhostEdge(edge: TransitionEdge, drawing: Drawing): TransitionEdge {
  const { transition } = edge.data!;
  if (isGhostTransition(transition))
    return { ...edge, data: { ...edge.data!, siblings: 1 }, selectable: false, deletable: false, reconnectable: false };
  const siblings = drawing.transitions.filter((one) => one.from === transition.from).length;
  return siblings === edge.data!.siblings ? edge : { ...edge, data: { ...edge.data!, siblings } };
}
