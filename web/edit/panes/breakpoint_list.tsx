// All breakpoints: on, off, away; and where the run stands when one has stopped it.

import { hitText } from "../../console/breakpoints/break_points.ts";
import { BreakpointEntry } from "../../console/breakpoints/breakpoint_entry.tsx";
import { SentenceField } from "../../console/breakpoints/sentence_field.tsx";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { type Breakpoint, Control_Action, Status_Mode } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kLost = [
  "Lost: not in the drawing",
  "What it was set on is not in the drawing any more; if it comes back, so does this",
] as const;

export function Breakpoints() {
  const live = useLivePage();
  const all = useSessionPart("breakpoints");
  return (
    <section aria-label="Breakpoints">
      <header className="columns spread">
        <h3>Breakpoints</h3>
        {all.length > 1 && (
          <Button tone="quiet" onPress={() => void live.marks.removeBreakpoint(0)}>
            Remove all
          </Button>
        )}
      </header>
      <SentenceField onSet={(condition) => live.marks.setSentence(condition)} />
      {all.length === 0 ? (
        <p className="small muted">
          None. The menu of a transition, a wire or a node (right button, or its details) sets one; or say above when
          the run is to pause.
        </p>
      ) : (
        <ul className="break-list">
          {all.map((one) => (
            <Entry key={one.id} breakpoint={one} />
          ))}
        </ul>
      )}
    </section>
  );
}

function Entry({ breakpoint }: { breakpoint: Breakpoint }) {
  const live = useLivePage();
  const drawnAt = useLiveState((state) => state.drawnAt.get(breakpoint.id));
  return (
    <BreakpointEntry
      breakpoint={breakpoint}
      lost={drawnAt?.isLost ? kLost : undefined}
      onGo={drawnAt && !drawnAt.isLost ? () => live.goTo(drawnAt) : undefined}
      onSwitch={(isOn) => void live.marks.switchBreakpoint(breakpoint, isOn)}
      onRemove={() => void live.marks.removeBreakpoint(breakpoint.id)}
    />
  );
}

/** Which breakpoint has paused the run, and the way there. */
export function HaltedNotice() {
  const live = useLivePage();
  const halted = useSessionPart("halted");
  const status = useSessionPart("status");
  const drawnAt = useLiveState((state) => state.drawnAt);
  if (!halted || status?.mode !== Status_Mode.PAUSED) return null;
  const hit = halted.hits[0]!;
  const known = drawnAt.get(hit.breakpoint);
  const place = known?.isLost ? undefined : known;
  const show = () => {
    if (hit.robot !== 0) live.model.select(selectRobots([hit.robot]));
    if (place) live.goTo(place);
  };
  return (
    <div className="notice hold sim-halted" role="alert">
      <Icon name="pause" />
      <span className="grow">
        {sentence(hitText(hit))}
        {halted.hits.length > 1 ? ` And ${halted.hits.length - 1} more.` : ""}
      </span>
      {(place || hit.robot !== 0) && <Button onPress={show}>Show</Button>}
      <Button onPress={() => void live.operator.control(Control_Action.RESUME)}>Go on</Button>
    </div>
  );
}
