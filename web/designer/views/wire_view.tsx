// A wire: coloured by what flows in it, with its value beside it while robots run.
import { BaseEdge, EdgeLabelRenderer, type EdgeProps } from "@xyflow/react";
import { memo } from "react";
import { isGhost, useIsNewWire } from "../compare/compared.ts";
import type { CanvasWire } from "../drawing/flow.ts";
import { badgePlace, wirePath } from "../drawing/wire_path.ts";
import { LiveShown } from "../running/badge.tsx";
import { useLive } from "../running/use_live.ts";
import { useCanvas } from "../sight/canvas_store.ts";

export const WireView = memo(function WireView(props: EdgeProps<CanvasWire>) {
  const { sourceX, sourceY, targetX, targetY, data, selected } = props;
  const distance = useCanvas((state) => state.distance);
  const value = useLive(data?.page ?? "", data?.wire.live ?? "");
  const [from, to] = [
    { x: sourceX, y: sourceY },
    { x: targetX, y: targetY },
  ];
  const { path } = wirePath(from, to);
  const { at, isAbove } = badgePlace(from, to);
  const isNew = useIsNewWire(data?.wire);
  const differs = isGhost(props.id) ? "differs removed" : isNew ? "differs added" : "";
  const classes = `wire flow-${data?.flow ?? "percept"} ${data?.wire.isActive ? "moves-sensor" : ""} ${selected ? "selected" : ""} ${differs}`;
  if (distance !== "near") return <path d={path} className={`react-flow__edge-path ${classes}`} fill="none" />;
  return (
    <>
      <BaseEdge path={path} className={classes} interactionWidth={16} />
      {(value || selected) && (
        <EdgeLabelRenderer>
          <span
            className={`wire-label number ${value ? "live" : ""} ${value?.isHeld ? "held" : ""}`}
            style={{ transform: `translate(${isAbove ? "-100%" : "-50%"}, -50%) translate(${at.x}px, ${at.y}px)` }}
          >
            {value ? <LiveShown value={value} /> : `${data?.wire.type}${data?.wire.unit ? ` [${data.wire.unit}]` : ""}`}
          </span>
        </EdgeLabelRenderer>
      )}
    </>
  );
});
