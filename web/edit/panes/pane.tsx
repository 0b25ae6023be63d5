// The simulator beside the canvas: how it stands, the map, and below it what is known of the robot that is selected.
import { useEffect } from "react";
import { StatesOverTime } from "../../console/selection/states_over_time.tsx";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { spokenPath } from "../../core/port_words.ts";
import { Status_Mode } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { duration } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { isMoving, runButton } from "../run/run_button.ts";
import { showProblem } from "../run/run_context.ts";
import { Breakpoints, HaltedNotice } from "./breakpoint_list.tsx";
import { HeldValues } from "./hold_value.tsx";
import { InSession } from "./in_session.tsx";
import { MapHost } from "./map_host.tsx";
import { Probes } from "./probes.tsx";
import { useLivePage, useLiveState, useSituation } from "./use_live_part.ts";

export default function LivePane() {
  return (
    <InSession>
      <div className="sim">
        <RunLine />
        <HaltedNotice />
        <Place />
        <BelowMap />
      </div>
    </InSession>
  );
}

const kModes: Readonly<Record<Status_Mode, readonly [string, string]>> = {
  [Status_Mode.NO_MISSION]: ["Nothing runs", ""],
  [Status_Mode.READY]: ["Ready", ""],
  [Status_Mode.RUNNING]: ["Running", "go"],
  [Status_Mode.PAUSED]: ["Paused", "hold"],
  [Status_Mode.WAITING]: ["Running", "go"],
  [Status_Mode.STOPPED]: ["Emergency stop", "danger"],
  [Status_Mode.ENDED]: ["Ended", ""],
};

function RunLine() {
  const now = useSituation();
  const time = useSessionPart("time");
  const count = useSessionPart("roster").robots.length;
  const [word, tone] = kModes[now.mode];
  const isOther = !now.isOurs && now.mode !== Status_Mode.NO_MISSION;
  return (
    <div className="sim-standing">
      <span className={`pill ${tone}`}>
        <span className="dot" />
        {word}
      </span>
      <span className="number" data-testid="sim-time">
        {duration(time, true)}
      </span>
      {now.isElsewhen && <span className="pill past">Not now</span>}
      <span className="small muted">
        {count} {count === 1 ? "robot" : "robots"}
      </span>
      {isOther && <span className="small muted">another mission</span>}
      {now.isOurs && !now.isCurrent && isMoving(now.mode) && (
        <span className="small hold-text">the text has changed since</span>
      )}
    </div>
  );
}

/** The map; without one, what can be done. */
function Place() {
  const live = useLivePage();
  const now = useSituation();
  const scene = useSessionPart("scene");
  const error = useLiveState((state) => state.error);
  const takenOver = useLiveState((state) => state.takenOver);
  const fieldError = useLiveState((state) => state.fieldError);
  const field = useLiveState((state) => (state.showsField ? state.field : null));
  const isReading = useLiveState(({ showsField, field, fieldError }) => showsField && !field && fieldError === "");
  const isPlacing = useLiveState((state) => state.isPlacing);
  const isEmpty = !scene || now.mode === Status_Mode.NO_MISSION;
  return (
    <div className="sim-place">
      {error !== "" && (
        <p className="notice danger" role="alert">
          <Icon name="warning" />
          <span className="grow">{error}</span>
          {now.errors > 0 && (
            <Button tone="link" onPress={() => showProblem(live.designer)}>
              Show why
            </Button>
          )}
        </p>
      )}
      {takenOver !== "" && !isEmpty && (
        <p className="sim-note sim-taken-over small" role="status">
          <span className="grow">{takenOver}</span>
          <IconButton icon="close" label="Read" onPress={() => live.store.setState({ takenOver: "" })} />
        </p>
      )}
      {fieldError !== "" && (
        <p className="notice" role="status">
          No movement field: {fieldError}
        </p>
      )}
      {isReading && !isEmpty && (
        <p className="sim-note small" role="status">
          Reading the movement field…
        </p>
      )}
      {field && (
        <p className="sim-note small" role="status">
          Movement field of <b>{field.title}</b>. {sentence(field.note)}
        </p>
      )}
      {isPlacing && (
        <p className="sim-note small" role="status">
          Click where a robot starts; drag to move, click on one to take it away.
        </p>
      )}
      {!isEmpty && <MapHost />}
      {isEmpty && <NoMap />}
    </div>
  );
}

/** Where the map would be: why there is none, and what can be done. */
function NoMap() {
  const live = useLivePage();
  const now = useSituation();
  const link = useSessionPart("link");
  const { act, hint } = runButton(now);
  return (
    <div className="sim-empty">
      {link.state !== "open" ? (
        <p className="muted">{link.reason === "" ? "Connecting…" : `No simulator: ${link.reason}.`}</p>
      ) : now.isBusy ? (
        <p className="muted">Compiling…</p>
      ) : (
        <>
          <p className="muted">{act === "none" ? `${hint}.` : "Robots that run what is drawn are shown here."}</p>
          {now.errors > 0 ? (
            <Button icon="warning" onPress={() => showProblem(live.designer)}>
              It does not compile: show why
            </Button>
          ) : (
            now.hasSubject && (
              <Button tone="go" icon="play" onPress={() => void live.trials.press()}>
                Run
              </Button>
            )
          )}
        </>
      )}
    </div>
  );
}

function BelowMap() {
  const notes = useLiveState((state) => state.tried?.notes) ?? [];
  return (
    <div className="sim-below">
      <RobotChoice />
      <Probes />
      <HeldValues />
      <Breakpoints />
      {notes.length > 0 && (
        <section aria-label="What was assumed">
          <h3>What was assumed</h3>
          <ul className="small muted">
            {notes.map((note) => (
              <li key={note}>{note}</li>
            ))}
          </ul>
        </section>
      )}
    </div>
  );
}

/** Which robot's values the drawing shows, and of which place where the page runs in several. */
function RobotChoice() {
  const live = useLivePage();
  const roster = useSessionPart("roster");
  const selected = useSessionPart("selection").robots[0] ?? 0;
  const details = useSessionPart("details");
  const { places, place } = useLiveState((state) => state);
  const states = details.get(selected)?.states ?? [];
  useEffect(() => live.follower.look(), [live]);
  if (roster.robots.length === 0) return null;
  return (
    <section aria-label="Robot">
      <div className="sim-whose">
        <Choice
          label="Values of"
          value={String(selected)}
          choices={roster.robots.slice(0, 200).map(({ id }) => [String(id), roster.nameOf(id)] as const)}
          onChange={(id) => live.model.select(selectRobots([Number(id)]))}
        />
        {places.length > 1 && (
          <Choice
            label="This page as it runs in"
            value={place}
            choices={places.map((one) => [one, one === "" ? "the robot itself" : spokenPath(one)] as const)}
            onChange={(chosenPlace) => live.store.setState({ chosenPlace })}
          />
        )}
      </div>
      {states.length > 0 && <p className="small muted">{states.map(spokenPath).join(" · ")}</p>}
      {selected !== 0 && <StatesOverTime robot={selected} />}
      {places.length === 0 && <p className="small muted">Nothing of this page runs in this robot.</p>}
    </section>
  );
}
