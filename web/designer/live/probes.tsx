// Values that stay in sight, whatever page is shown.
import { Button, IconButton } from "../../console/ui/controls.tsx";
import { spokenEnd, spokenPath } from "../../core/port_words.ts";
import { LiveArrow } from "./badge.tsx";
import { kPinPage } from "./follower.ts";
import type { Pin } from "./live_state.ts";
import { tracePath } from "./traces.ts";
import { useLive } from "./use_live.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kWidth = 180;
const kHeight = 26;

export function Probes() {
  const pins = useLiveState((state) => state.pins);
  if (pins.length === 0) return null;
  return (
    <section aria-label="Probes">
      <h3>Probes</h3>
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
  const name = spokenPath(pin.port);
  const end = spokenEnd(pin.port);
  // Its end says what it is; the way there only where another probe ends alike.
  const isAlone = useLiveState(({ pins }) => pins.filter(({ port }) => spokenEnd(port) === end).length < 2);
  return (
    <li title={name}>
      <Button tone="link" className="ellipsis" onPress={() => live.goTo(pin)}>
        {isAlone ? end : name}
      </Button>
      <span className="probe-value number">
        {value?.vector && <LiveArrow {...value.vector} />}
        {pin.isLost ? <span title="What it was on is not in the drawing any more">lost</span> : (value?.text ?? "–")}
      </span>
      <svg className="probe-plot" viewBox={`0 0 ${kWidth} ${kHeight}`} aria-hidden="true">
        <path d={tracePath(value?.trace ?? [], kWidth, kHeight)} />
      </svg>
      <IconButton icon="close" label={`Take away the probe of ${name}`} onPress={() => void live.unpin(pin)} />
    </li>
  );
}
