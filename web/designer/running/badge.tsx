// The value of what is drawn, while robots run: an arrow for a vector, a small plot for a number, words.
import { Icon } from "../../ui/controls/icons.tsx";
import { tracePath } from "./traces.ts";
import { useLive } from "./use_live.ts";
import type { LiveValue } from "./values.ts";

const kWidth = 30;
const kHeight = 11;

/** Beside a node's output that leads nowhere: else its wires show the value. */
export function LiveBadge({ page, live, y }: { page: string; live: string; y: number }) {
  const value = useLive(page, live);
  if (!value || y < 0) return null;
  return (
    <span className={`live-badge number ${value.isHeld ? "held" : ""}`} style={{ top: y - 30 }}>
      <LiveShown value={value} />
    </span>
  );
}

export function LiveShown({ value }: { value: LiveValue }) {
  const path = value.trace && !value.vector ? tracePath(value.trace, kWidth, kHeight) : "";
  return (
    <>
      {value.isHeld && <HeldSign />}
      {value.vector && <LiveArrow {...value.vector} />}
      {path !== "" && (
        <svg className="live-plot" viewBox={`0 0 ${kWidth} ${kHeight}`} aria-hidden="true">
          <path d={path} />
        </svg>
      )}
      {value.text}
    </>
  );
}

function HeldSign() {
  return (
    <span className="held-sign" title="Held: not what its node computes">
      <Icon name="lock" />
    </span>
  );
}

/** A vector of the robot's frame: ahead is up. */
export function LiveArrow({ x, y }: { x: number; y: number }) {
  const strength = Math.hypot(x, y);
  if (!(strength > 1e-3)) {
    return (
      <svg className="live-arrow" viewBox="-12 -12 24 24" aria-hidden="true">
        <circle r="2" />
      </svg>
    );
  }
  // A weak one can still be told apart from none.
  const length = 0.35 + 0.65 * Math.min(1, strength);
  const turn = (Math.atan2(-y, x) * 180) / Math.PI;
  return (
    <svg className="live-arrow" viewBox="-12 -12 24 24" aria-hidden="true">
      <path
        d={`M0 ${9 * length}V${-9 * length}M-3.500 ${-9 * length + 4}L0 ${-9 * length}L3.500 ${-9 * length + 4}`}
        transform={`rotate(${turn.toFixed(0)})`}
      />
    </svg>
  );
}
