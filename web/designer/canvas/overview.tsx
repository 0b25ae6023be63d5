// Where on the page one is.
import { type Node as FlowNode, MiniMap, useStore } from "@xyflow/react";
import { useMemo } from "react";
import { useCanvas } from "../sight/canvas_store.ts";
import { boundsOf, holdsAll } from "../sight/view.ts";

const kMiniSize = { width: 160, height: 110 };
const kSmallMini = { width: 100, height: 72 }; // beside panes that take the room

/** A page that is seen as a whole needs none. */
export function Overview({ nodes }: { nodes: readonly FlowNode[] }) {
  const size = useStore((state) => (state.width > 3.5 * kMiniSize.width ? kMiniSize : kSmallMini));
  const hasRoom = useStore((state) => state.width > 3 * kSmallMini.width && state.height > 3 * kMiniSize.height);
  const bounds = useMemo(() => boundsOf(nodes), [nodes]);
  const isWhole = useCanvas(({ view }) => holdsAll(view, bounds));
  if (isWhole || !hasRoom) return null;
  return (
    <MiniMap
      style={size}
      pannable
      zoomable
      ariaLabel="Overview of the drawing"
      nodeStrokeWidth={0}
      className="minimap"
      nodeClassName={toneClass}
    />
  );
}

function toneClass(node: FlowNode): string {
  if (node.type === "state") return "tone-sequence";
  if (node.type !== "node") return `mini-${node.type}`;
  return `tone-${(node.data as { form: { tone: string } }).form.tone}`;
}
