// The value of a node's output beside it, while robots run.
import { useLive } from "./use_live.ts";

export function LiveBadge({ page, live, y }: { page: string; live: string; y: number }) {
  const value = useLive(page, live);
  if (!value || y < 0) return null;
  return (
    <span className="live-badge number" style={{ top: y - 30 }}>
      {value.vector && <Arrow x={value.vector.x} y={value.vector.y} />}
      {value.text}
    </span>
  );
}

/** A vector of the robot's frame: ahead is up. */
function Arrow({ x, y }: { x: number; y: number }) {
  const length = Math.min(1, Math.hypot(x, y));
  const turn = (Math.atan2(-y, x) * 180) / Math.PI;
  return (
    <svg className="live-arrow" viewBox="-12 -12 24 24" aria-hidden="true">
      <path
        d={`M0 ${9 * length}V${-9 * length}M-3.500 ${-9 * length + 4}L0 ${-9 * length}L3.500 ${-9 * length + 4}`}
        transform={`rotate(${turn})`}
      />
    </svg>
  );
}
