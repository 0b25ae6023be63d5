// Values that stay in sight, whatever page is shown.

import { spokenEnd, spokenPath } from "../../core/port_words.ts";
import { LiveArrow } from "../../designer/running/badge.tsx";
import { tracePath, traceRange } from "../../designer/running/traces.ts";
import { useLive } from "../../designer/running/use_live.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { kPinPage, kPinSpan } from "../run/follower.ts";
import type { Pin } from "../run/live_state.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kWidth = 180;
const kHeight = 26;

export function Probes() {
  const pins = useLiveState((state) => state.pins);
  const span = useLive(kPinPage, kPinSpan)?.text ?? "";
  if (pins.length === 0) return null;
  return (
    <section aria-label="Probes">
      <header className="columns spread">
        <h3>Probes</h3>
        <span className="small muted number">{span}</span>
      </header>
      <ul className="probe-list">
        {pins.map((pin) => (
          <Probe key={`${pin.document} ${pin.mark}`} pin={pin} />
        ))}
      </ul>
    </section>
  );
}

function Probe({ pin }: { pin: Pin }) {
  const live = useLivePage();
  const value = useLive(kPinPage, pin.port);
  const range = traceRange(value?.trace ?? []);
  const name = spokenPath(pin.port);
  const end = spokenEnd(pin.port);
  // Its end says what it is; the way there only where another probe ends alike.
  const isAlone = useLiveState(({ pins }) => pins.filter(({ port }) => spokenEnd(port) === end).length < 2);
  return (
    <li title={name}>
      <Button tone="link" onPress={() => live.goTo(pin)}>
        <span className="ellipsis">{isAlone ? end : name}</span>
      </Button>
      <span className="probe-value number">
        {value?.vector && <LiveArrow {...value.vector} />}
        {pin.isLost ? <span title="What it was on is not in the drawing any more">lost</span> : (value?.text ?? "–")}
      </span>
      <svg className="probe-plot" viewBox={`0 0 ${kWidth} ${kHeight}`} aria-hidden="true">
        <path d={tracePath(value?.trace ?? [], kWidth, kHeight)} />
      </svg>
      <span className="probe-range number" aria-hidden="true">
        {range && (
          <>
            <span>{shownEnd(range.high, range)}</span>
            <span>{shownEnd(range.low, range)}</span>
          </>
        )}
      </span>
      <IconButton
        icon="close"
        label={`Take away the probe of ${name}`}
        onPress={() => void live.marks.unpin(pin.document, pin.mark)}
      />
    </li>
  );
}

/** An end of the plot's range, as exact as the range asks for; in the unit that stands with the value. */
function shownEnd(value: number, { low, high }: { low: number; high: number }): string {
  const digits = Math.min(3, Math.max(0, 1 - Math.floor(Math.log10(high - low))));
  return String(Number(value.toFixed(digits)));
}
