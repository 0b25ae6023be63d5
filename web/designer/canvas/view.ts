// The canvas's camera, for actions that move it.
import type { ReactFlowInstance } from "@xyflow/react";

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
  void current?.fitView({
    ...kFit,
    duration: 200,
    ...(ids ? { nodes: ids.map((id) => ({ id })) } : {}),
  });
}
