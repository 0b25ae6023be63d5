import type { Model } from "../../core/model.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { duration } from "../../ui/words/format.ts";
import { kStopShortcut } from "../actions/run_actions.ts";
import { People } from "../clients/people.tsx";
import { RunButton, StepButton } from "../mission/run_button.tsx";
import { situationOf } from "../mission/situation.ts";
import { SpeedControl } from "../mission/speed_control.tsx";
import { stateOf } from "../mission/state.ts";
import { nameOf, nextRedo, nextUndo } from "../session/history.ts";
import { emergencyStop, redo, save, undo } from "../session/orders.ts";
import { isAlike, useIsElsewhen, useIsRecording, usePart, useReading, useSession, useUi } from "../session/session.ts";
import { missionEdits } from "../session/ui.ts";
import { FileMenu } from "../start/file_menu.tsx";
import { stopWords } from "./stop_state.ts";
import { useStopState } from "./use_stop.ts";

/** In a narrow window what is pressed in a hurry has a line of its own, and the rest the next one. */
export function TopBar() {
  const session = useSession();
  // In one nothing goes on that could be stopped.
  const isRecording = useIsRecording();
  return (
    <header className="topbar">
      <div className="topbar-first">
        <FileMenu />
        <RunState />
        {!isRecording && <RunButton />}
        {!isRecording && <StopButton />}
      </div>
      <div className="topbar-rest">
        <div className="topbar-mission">
          <Title />
          {!isRecording && <UndoButtons />}
        </div>
        <div className="topbar-run">
          {!isRecording && <StepButton />}
          <Clocks />
          {!isRecording && <SpeedControl />}
          <span className="gap" />
          <People />
          <Hint text="Search everything" shortcut={shownShortcut("ctrl+k")}>
            <Button tone="quiet" className="find" icon="search" onPress={() => session.ui.set("dialog", "palette")}>
              <span className="hidden-text">Search everything</span>
              <kbd>{shownShortcut("ctrl+k")}</kbd>
            </Button>
          </Hint>
        </div>
      </div>
    </header>
  );
}

function Title() {
  const session = useSession();
  const plan = usePart("plan");
  const project = usePart("project");
  const edits = usePart("edits");
  const line = useReading(["timeLine"], recordingOf, isAlike);
  const mission = plan?.name || project?.mission || "missionlab";
  const name = line?.recording ? `Recording ‘${line.recording}’` : mission;
  return (
    <>
      <h1 className="title ellipsis" title={project?.mission ?? ""}>
        {name}
      </h1>
      {line?.recording && line.outcome && <span className="pill">{endOf(line.outcome)}</span>}
      {edits?.isDirty && !line?.recording && (
        <Hint text="Save" shortcut={shownShortcut("ctrl+s")}>
          <Button tone="quiet" className="pill hold" onPress={() => save(session)}>
            Not saved
          </Button>
        </Hint>
      )}
    </>
  );
}

function recordingOf(model: Model): { recording: string; outcome: string } | null {
  const line = model.get("timeLine");
  return line && { recording: line.recording, outcome: line.outcome };
}

function UndoButtons() {
  const session = useSession();
  usePart("edits");
  const history = useUi("history");
  const edits = missionEdits(session.model);
  const undoName = nameOf(nextUndo(history, edits));
  const redoName = nameOf(nextRedo(history, edits));
  return (
    <span className="columns" style={{ gap: 0, flexWrap: "nowrap" }}>
      <IconButton
        icon="undo"
        label={undoName ? `Undo ${undoName}` : "Nothing to undo"}
        shortcut={shownShortcut("ctrl+z")}
        isDisabled={!undoName}
        onPress={() => undo(session)}
      />
      <IconButton
        icon="redo"
        label={redoName ? `Redo ${redoName}` : "Nothing to redo"}
        shortcut={shownShortcut("ctrl+shift+z")}
        isDisabled={!redoName}
        onPress={() => redo(session)}
      />
    </span>
  );
}

function RunState() {
  const link = usePart("link");
  const isRecording = useIsRecording();
  const isElsewhen = useIsElsewhen();
  const reach = link.state !== "open" ? "closed" : link.silentSince !== 0 ? "silent" : "open";
  const { word, tone } = useReading(
    ["status", "documents"],
    (model) => stateOf(model.get("status") ?? undefined, reach, situationOf(model).errors),
    isAlike,
  );
  return (
    <span className={`pill ${tone}`} role="status" data-testid="run-state">
      <span className="dot" />
      {isElsewhen && reach === "open" && !isRecording ? `Was: ${word}` : word}
    </span>
  );
}

/** Of a recording; where it does not say how it ended, it was cut off. */
function endOf(outcome: string): string {
  return outcome === "cut off" ? "Cut off" : `Ended: ${outcome}`;
}

function useMissionClock(): { date: string; hours: string } {
  const clock = useReading(["status"], (model) => model.get("status")?.missionClock ?? "");
  const [date = "", hours = ""] = clock.split("T");
  return { date, hours: hours.slice(0, 8) };
}

function Clocks() {
  return (
    <span className="clocks number">
      <Hint text={<ClockWords />}>
        <Button tone="quiet" className="runtime" data-testid="run-time">
          <span className="hidden-text">Run time </span>
          <RunTime />
        </Button>
      </Hint>
      <MissionClock />
    </span>
  );
}

function ClockWords() {
  const { hours } = useMissionClock();
  return `Time since the run began${hours ? `; the mission's clock shows ${hours}` : ""}`;
}

function MissionClock() {
  const { date, hours } = useMissionClock();
  if (!hours) return null;
  return (
    <span className="mission-clock muted small" title={`Mission clock: ${date} ${hours}`}>
      <span className="hidden-text">Mission clock </span>
      {hours}
    </span>
  );
}

/** Changes many times a second, which the button round it need not know. */
function RunTime() {
  const time = usePart("time");
  const told = useReading(["status"], (model) => model.get("status")?.time ?? 0);
  const isElsewhen = useIsElsewhen();
  return duration(isElsewhen ? time : Math.max(time, told), true);
}

export function StopButton() {
  const session = useSession();
  const stop = useStopState();
  const words = stopWords(stop);
  return (
    <Button
      className={`estop ${stop.kind}`}
      aria-keyshortcuts="Control+."
      onPress={() => void emergencyStop(session)}
      data-testid="emergency-stop"
      // Dialogs leave it reachable.
      data-react-aria-top-layer="true"
    >
      <Icon name="stop" />
      <span className="estop-words">
        <span>
          <span className="estop-long">EMERGENCY </span>STOP
        </span>
        {words !== "" && <span className="estop-state">{words}</span>}
      </span>
      <kbd>{shownShortcut(kStopShortcut)}</kbd>
    </Button>
  );
}
