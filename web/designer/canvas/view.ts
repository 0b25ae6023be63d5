// The canvas's camera, for actions that move it.
import type { ReactFlowInstance } from "@xyflow/react";

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
    padding: 0.1,
    maxZoom: 1,
    duration: 200,
    ...(ids ? { nodes: ids.map((id) => ({ id })) } : {}),
  });
}
