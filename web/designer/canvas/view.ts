// The canvas's camera, for actions that move it.
import { getViewportForBounds, type ReactFlowInstance } from "@xyflow/react";
import { curveOf, labelMarks, type TransitionEdge } from "../states/flow.ts";
import { pathOf } from "../states/geometry.ts";
import { labelSize } from "../states/label.ts";

/** Everything is seen, and nothing of it stands below the tools at the left. */
export const kFit = {
  padding: { left: "64px", right: "40px", top: "28px", bottom: "28px" },
  maxZoom: 1,
} as const;

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function boundsOf(
  nodes: readonly { position: { x: number; y: number }; width?: number; height?: number }[],
): Box | null {
  if (nodes.length === 0) return null;
  const x = Math.min(...nodes.map((node) => node.position.x));
  const y = Math.min(...nodes.map((node) => node.position.y));
  const right = Math.max(...nodes.map((node) => node.position.x + (node.width ?? 0)));
  const bottom = Math.max(...nodes.map((node) => node.position.y + (node.height ?? 0)));
  return { x, y, width: right - x, height: bottom - y };
}

/** Of the nodes, and of the ways between states with what is written at them. */
function seenBounds(flow: ReactFlowInstance): Box | null {
  const nodes = flow.getNodes();
  const boxes = new Map(nodes.map((node) => [node.id, boxOf(node)]));
  const seen = [...boxes.values()];
  for (const edge of flow.getEdges()) {
    const [from, to] = [boxes.get(edge.source), boxes.get(edge.target)];
    if (edge.type !== "transition" || !edge.data || !from || !to) continue;
    const { transition, route, lines, scale, siblings } = edge.data as NonNullable<TransitionEdge["data"]>;
    const curve = curveOf(transition, route, from, to);
    const size = labelSize(lines, labelMarks(transition, siblings), scale);
    const { x, y } = curve.pointAt(route.at);
    seen.push(...pathOf(curve).map((at) => ({ ...at, width: 0, height: 0 })));
    seen.push({ x: x - size.width / 2, y: y - size.height / 2, ...size });
  }
  return boundsOf(seen.map(({ x, y, width, height }) => ({ position: { x, y }, width, height })));
}

function boxOf({
  position,
  width = 0,
  height = 0,
}: {
  position: Box | { x: number; y: number };
  width?: number;
  height?: number;
}): Box {
  return { x: position.x, y: position.y, width, height };
}

/** Everything is brought into sight; done once it is there, `duration` [ms] later. */
export async function fitAll(flow: ReactFlowInstance, duration = 0): Promise<void> {
  const bounds = seenBounds(flow);
  const canvas = document.querySelector(".canvas")?.getBoundingClientRect();
  if (!bounds || !canvas || canvas.width === 0 || canvas.height === 0) return;
  const to = getViewportForBounds(bounds, canvas.width, canvas.height, 0.04, kFit.maxZoom, kFit.padding);
  await flow.setViewport(to, { duration });
}

/** Whether nothing of `what` is outside. */
export function holdsAll(view: Box, what: Box | null): boolean {
  if (!what) return true;
  return (
    what.x >= view.x &&
    what.y >= view.y &&
    what.x + what.width <= view.x + view.width &&
    what.y + what.height <= view.y + view.height
  );
}

let current: ReactFlowInstance | null = null;

export function setView(flow: ReactFlowInstance): () => void {
  current = flow;
  return () => {
    if (current === flow) current = null;
  };
}

export function camera(): ReactFlowInstance | null {
  return current;
}

/** Everything, or what is named. */
export function fit(ids?: readonly string[]): void {
  if (!ids && current) {
    void fitAll(current, 200);
    return;
  }
  void current?.fitView({
    ...kFit,
    duration: 200,
    ...(ids ? { nodes: ids.map((id) => ({ id })) } : {}),
  });
}
