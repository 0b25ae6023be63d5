// All wires of a large drawing seen from far away: one path for each colour instead of one element for each wire.
import { type Edge, type Node as FlowNode, ViewportPortal } from "@xyflow/react";
import { memo, useMemo } from "react";
import { wirePath } from "../drawing/wire_path.ts";

export const FarWires = memo(function FarWires({ nodes, edges }: { nodes: FlowNode[]; edges: Edge[] }) {
  const paths = useMemo(() => pathsOf(nodes, edges), [nodes, edges]);
  return (
    <ViewportPortal>
      <svg className="far-wires" aria-hidden="true">
        {[...paths].map(([flow, path]) => (
          <path key={flow} d={path} className={`react-flow__edge-path wire flow-${flow}`} fill="none" />
        ))}
      </svg>
    </ViewportPortal>
  );
});

function pathsOf(nodes: FlowNode[], edges: Edge[]): Map<string, string> {
  const byId = new Map(nodes.map((node) => [node.id, node]));
  const paths = new Map<string, string>();
  for (const edge of edges) {
    const from = ends(byId.get(edge.source), edge.sourceHandle);
    const to = ends(byId.get(edge.target), edge.targetHandle);
    if (!from || !to) continue;
    const flow = String(edge.data?.flow ?? "percept");
    paths.set(flow, `${paths.get(flow) ?? ""}${wirePath(from, to).path}`);
  }
  return paths;
}

function ends(node: FlowNode | undefined, handle: string | null | undefined): { x: number; y: number } | undefined {
  const found = node?.handles?.find((one) => one.id === handle);
  if (!node || !found) return undefined;
  return {
    x: node.position.x + found.x + (found.width ?? 0) / 2,
    y: node.position.y + found.y + (found.height ?? 0) / 2,
  };
}
