// All breakpoints: on, off, away; and where the run stands when one has stopped it.

import { usePart as useSessionPart } from "../../console/session/session.ts";
import { type Breakpoint, Control_Action, Status_Mode } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { Button, IconButton, Switch } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { breakpointText, hitText } from "../run/break_points.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kLost = "What it was set on is not in the drawing any more; if it comes back, so does this";

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
      {all.length === 0 ? (
        <p className="small muted">
          None. The menu of a transition, a wire or a node (right button, or its details) sets one.
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
  const halted = useSessionPart("halted");
  const drawnAt = useLiveState((state) => state.drawnAt.get(breakpoint.id));
  const text = breakpointText(breakpoint);
  const isHit = halted?.hits.some((hit) => hit.breakpoint === breakpoint.id) ?? false;
  const hits = Number(breakpoint.hits);
  return (
    <li className={isHit ? "hit" : ""}>
      <Switch
        label={<span className="hidden-text">{text}: stops the run</span>}
        value={!breakpoint.isOff}
        onChange={(on) => void live.marks.switchBreakpoint(breakpoint, on)}
      />
      {drawnAt && !drawnAt.isLost ? (
        <Button tone="link" className="ellipsis" onPress={() => live.goTo(drawnAt)}>
          {text}
        </Button>
      ) : (
        <span className="ellipsis">{text}</span>
      )}
      <span className="small muted grow" title={drawnAt?.isLost ? kLost : breakpoint.error}>
        {drawnAt?.isLost
          ? "Lost: not in the drawing"
          : breakpoint.error !== ""
            ? sentence(breakpoint.error)
            : hits > 0
              ? `${hits}×`
              : ""}
      </span>
      <IconButton
        icon="close"
        label={`Remove the breakpoint ${text}`}
        onPress={() => void live.marks.removeBreakpoint(breakpoint.id)}
      />
    </li>
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
