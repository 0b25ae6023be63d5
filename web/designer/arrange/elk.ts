// A graph as elk wants it, and elk's answer as places. Pure; elk itself runs in the worker.
import type { ElkNode } from "elkjs/lib/elk-api";
import type { LayoutGraph } from "./graph.ts";

export const kPitch = 8; // places are multiples of it, as on the canvas's grid [px]

const kDataflow: Record<string, string> = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.spacing.nodeNode": "32",
  "elk.spacing.componentComponent": "48",
  "elk.layered.spacing.nodeNodeBetweenLayers": "88",
  "elk.layered.considerModelOrder.strategy": "NODES_AND_EDGES",
  "elk.separateConnectedComponents": "true",
};
const kStates: Record<string, string> = {
  "elk.algorithm": "layered",
  "elk.spacing.nodeNode": "56",
  "elk.spacing.edgeNode": "28",
  "elk.spacing.edgeLabel": "6",
  "elk.layered.spacing.nodeNodeBetweenLayers": "40",
  "elk.layered.considerModelOrder.strategy": "PREFER_NODES",
  "elk.edgeLabels.inline": "true",
};
const kPlacement = { careful: "NETWORK_SIMPLEX", quick: "BRANDES_KOEPF" } as const;
/** `direction`: of states only; dataflow goes to the right. */
export function toElk(
  graph: LayoutGraph,
  method: keyof typeof kPlacement = "careful",
  direction: "RIGHT" | "DOWN" = "RIGHT",
): ElkNode {
  const isFlow = graph.kind === "dataflow";
  // On a page with errors a wire can lead to an input, or from an output, that its node does not have.
  const hasOutput = new Set(graph.nodes.filter((node) => node.outputY >= 0).map((node) => node.id));
  const hasInput = new Set(graph.nodes.flatMap((node) => node.inputs.map((input) => `${node.id}/${input.id}`)));
  return {
    id: "page",
    layoutOptions: {
      ...(isFlow ? kDataflow : { ...kStates, "elk.direction": direction }),
      "elk.layered.nodePlacement.strategy": kPlacement[method],
    },
    children: graph.nodes.map(
      (node): ElkNode => ({
        id: node.id,
        width: node.width,
        height: node.height,
        ...(isFlow
          ? {
              layoutOptions: { "elk.portConstraints": "FIXED_POS" },
              ports: [
                ...node.inputs.map((input) => ({
                  id: `${node.id}/${input.id}`,
                  x: 0,
                  y: input.y,
                  width: 0,
                  height: 0,
                  layoutOptions: { "elk.port.side": "WEST" },
                })),
                ...(node.outputY >= 0
                  ? [
                      {
                        id: `${node.id}>`,
                        x: node.width,
                        y: node.outputY,
                        width: 0,
                        height: 0,
                        layoutOptions: { "elk.port.side": "EAST" },
                      },
                    ]
                  : []),
              ],
            }
          : node.isFirst
            ? { layoutOptions: { "elk.layered.layering.layerConstraint": "FIRST" } }
            : {}),
      }),
    ),
    edges: graph.wires
      .filter((wire) => wire.from !== wire.to && (!isFlow || (hasOutput.has(wire.from) && hasInput.has(inputOf(wire)))))
      .map((wire, i) => ({
        id: `wire ${i}`,
        sources: [isFlow ? `${wire.from}>` : wire.from],
        targets: [isFlow ? inputOf(wire) : wire.to],
        // what is written at a transition wants room as well
        ...(wire.label ? { labels: [{ id: `label ${i}`, text: "x", ...wire.label }] } : {}),
      })),
  };
}

function inputOf(wire: { to: string; port: string }): string {
  return `${wire.to}/${wire.port}`;
}

export interface Spot {
  id: string;
  x: number;
  y: number;
}

export function fromElk(result: ElkNode): Spot[] {
  return (result.children ?? []).map(({ id, x = 0, y = 0 }) => ({ id, x: onPitch(x), y: onPitch(y) }));
}

export function onPitch(value: number): number {
  return Math.round(value / kPitch) * kPitch;
}
