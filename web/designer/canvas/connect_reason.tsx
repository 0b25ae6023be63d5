// Beside the pointer while a wire is drawn: why it does not fit where it is, or that it does.
import { useConnection, ViewportPortal } from "@xyflow/react";
import { useCanvas } from "../sight/canvas_store.ts";
import { reasonAgainst } from "../sight/wiring.ts";

export function ConnectReason() {
  const wire = useConnection();
  useCanvas((state) => state.fits);
  if (!wire.inProgress || !wire.toHandle || !wire.fromHandle) return null;
  const isForward = wire.fromHandle.type === "source";
  const reason = isForward
    ? reasonAgainst(wire.fromHandle.nodeId, wire.toHandle.nodeId, wire.toHandle.id ?? "")
    : reasonAgainst(wire.toHandle.nodeId, wire.fromHandle.nodeId, wire.fromHandle.id ?? "");
  return (
    <ViewportPortal>
      <div
        className={`connect-reason ${reason ? "refused" : "fits"}`}
        role="status"
        style={{ transform: `translate(${wire.to.x + 16}px, ${wire.to.y + 14}px)` }}
      >
        {reason || "fits"}
      </div>
    </ViewportPortal>
  );
}
