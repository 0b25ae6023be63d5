// The mission's steps, what runs now, and, until the first of them starts, the one large button.
import { memo, useEffect, useRef, useState } from "react";
import { Control_Action, Status_Mode } from "../../core/protocol.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Bar, Button, Hint } from "../../ui/controls/controls.tsx";
import { Icon, type IconName } from "../../ui/controls/icons.tsx";
import { MenuAt, type MenuEntry } from "../../ui/controls/menus.tsx";
import { distance, duration, readableMessage } from "../../ui/words/format.ts";
import { askFirst, control } from "../session/orders.ts";
import { isAlike, useMayOrder, useMode, usePart, useReading, useSession } from "../session/session.ts";
import { skipWords, stepWords } from "./main_button.ts";
import { StartButton } from "./run_button.tsx";
import { situationOf } from "./situation.ts";
import {
  type CommandRow,
  isSameRow,
  kStateWords,
  kStepOfOrder,
  missionProgress,
  type StepRow,
  type StepState,
  splitCommand,
  stepRows,
} from "./steps.ts";
import { unitPlace } from "./unit_place.ts";
import "./mission.css";

export function MissionPanel() {
  return (
    <>
      <MainControls />
      <RunningNow />
      <Steps />
    </>
  );
}

function MainControls() {
  const session = useSession();
  const mayOrder = useMayOrder();
  const mode = useMode();
  const step = useReading(["status"], (model) => stepWords(model.get("status")));
  const skip = useReading(["status"], (model) => skipWords(model.get("status")));
  const isBlocked = !mayOrder || mode === Status_Mode.NO_MISSION;
  const stands = isBlocked || mode === Status_Mode.STOPPED;
  const run = (action: Control_Action) => () => control(session, action);
  return (
    <div className="main-controls">
      <StartButton />
      <div className="transport" role="toolbar" aria-label="Run">
        <TransportButton
          icon="step"
          label="Step"
          hint={step}
          shortcut="n"
          isDisabled={stands}
          onPress={run(Control_Action.SINGLE_STEP)}
        />
        <TransportButton
          icon="skip"
          label="Skip"
          hint={skip}
          shortcut="shift+n"
          isDisabled={stands}
          onPress={run(Control_Action.SKIP_STEP)}
        />
        <TransportButton
          icon="cycle"
          label="Cycle"
          hint="Single control cycle, then paused"
          shortcut="c"
          isDisabled={stands}
          onPress={run(Control_Action.SINGLE_CYCLE)}
        />
        <TransportButton
          icon="rewind"
          label="Rewind"
          hint="To the first step; robots stay where they are"
          isDisabled={stands}
          onPress={run(Control_Action.REWIND)}
        />
        <TransportButton
          icon="restart"
          label="Restart"
          hint="The run begins anew with the same seed"
          isDisabled={isBlocked}
          onPress={() => askFirst(session, Control_Action.RESTART)}
        />
        <TransportButton
          icon="abort"
          label="Abort"
          hint="All robots stop, the mission ends"
          isDisabled={stands}
          onPress={() => askFirst(session, Control_Action.ABORT)}
        />
      </div>
    </div>
  );
}

interface TransportProps {
  icon: IconName;
  label: string;
  hint: string;
  shortcut?: string;
  isDisabled: boolean;
  onPress: () => void;
}

function TransportButton({ icon, label, hint, shortcut, isDisabled, onPress }: TransportProps) {
  return (
    <Hint text={hint} {...(shortcut ? { shortcut: shownShortcut(shortcut) } : {})}>
      <Button tone="quiet" className="transport-button" isDisabled={isDisabled} onPress={onPress}>
        <Icon name={icon} />
        {label}
      </Button>
    </Hint>
  );
}

const kNothing: readonly string[] = [];

function RunningNow() {
  const waits = useReading(["status"], (model) => model.get("status")?.waitsFor ?? kNothing, isAlike);
  const mode = useMode();
  if (waits.length === 0) return null;
  return (
    <section className={`waits ${mode === Status_Mode.WAITING ? "hold" : ""}`} aria-label="What the mission waits for">
      <h3>Waits for</h3>
      <ul>
        {waits.map((text) => (
          <li key={text}>{readableMessage(text)}</li>
        ))}
      </ul>
    </section>
  );
}

const kGettingReady = ["This mission is getting ready.", "Its steps appear once its robots are there."];
const kErrors = ["The text of this mission can't be understood.", "Its steps appear once the errors are mended."];
const kNoSteps = [
  "This mission has no steps yet.",
  "Write them in the Text panel, or send commands from the command line.",
];

function Steps() {
  const { model } = useSession();
  const plan = usePart("plan");
  const status = usePart("status");
  usePart("documents");
  const hasErrors = situationOf(model).errors > 0;
  const rows = stepRows(plan ?? undefined, status ?? undefined);
  const planned = rows.filter((row) => row.step !== kStepOfOrder);
  const done = planned.filter((row) => row.state === "done").length;
  const list = useRef<HTMLOListElement>(null);
  const current = rows.findIndex((row) => row.state === "running" || row.state === "next");
  const mayOrder = useMayOrder();
  const hasEnded = status?.mode === Status_Mode.ENDED;
  const [open, setOpen] = useState<OpenMenu | null>(null);
  const opened = open && rows.find((row) => row.key === open.key);
  // In sight also when the panel becomes lower.
  useEffect(() => {
    const show = () => list.current?.children[current]?.scrollIntoView?.({ block: "nearest" });
    show();
    const panel = list.current?.closest(".panel");
    if (!panel) return;
    const observer = new ResizeObserver(show);
    observer.observe(panel);
    return () => observer.disconnect();
  }, [current]);
  if (rows.length === 0) {
    const [what, then] = status?.isBeingMade ? kGettingReady : hasErrors ? kErrors : kNoSteps;
    return (
      <div className="empty">
        <p>{what}</p>
        <p className="small">{then}</p>
      </div>
    );
  }
  return (
    <section className="steps" aria-label="Steps">
      <header className="columns spread">
        <h3>Steps</h3>
        <span className="small muted number">
          {done} of {planned.length} done
        </span>
      </header>
      <Bar share={missionProgress(rows)} />
      <ol ref={list}>
        {rows.map((row) => (
          <Step key={row.key} row={row} isOpen={row.key === open?.key} onMenu={setOpen} />
        ))}
      </ol>
      {opened && open && (
        <StepMenu row={opened} at={open.button} mayOrder={mayOrder} hasEnded={hasEnded} onClose={() => setOpen(null)} />
      )}
    </section>
  );
}

/** Whose menu is open, and the button that it belongs to. */
interface OpenMenu {
  readonly key: string;
  readonly button: Element;
}

interface StepProps {
  row: StepRow;
  isOpen: boolean;
  onMenu: (open: OpenMenu) => void;
}

const Step = memo(DrawnStep, (a, b) => a.isOpen === b.isOpen && a.onMenu === b.onMenu && isSameRow(a.row, b.row));

function DrawnStep({ row, isOpen, onMenu }: StepProps) {
  return (
    <li
      className={`step ${row.state}`}
      aria-current={row.state === "running" || row.state === "next" ? "step" : undefined}
    >
      <span className="step-sign" title={kStateWords[row.state]}>
        <StateSign state={row.state} />
      </span>
      <div className="grow">
        {row.commands.map((command, i) => (
          <Command
            key={i}
            row={row}
            command={command}
            label={i === 0 ? (row.step === kStepOfOrder ? "typed" : row.label) : ""}
          />
        ))}
        <StepFoot row={row} />
      </div>
      <Button
        tone="quiet"
        className="square step-menu"
        aria-label={`Actions of ${nameOf(row)}`}
        aria-haspopup="menu"
        aria-expanded={isOpen}
        onPress={({ target }) => onMenu({ key: row.key, button: target })}
      >
        <Icon name="more" />
      </Button>
    </li>
  );
}

function nameOf(row: StepRow): string {
  return row.step === kStepOfOrder ? "typed command" : `step ${row.label}`;
}

function StateSign({ state }: { state: StepState }) {
  const icons: Partial<Record<StepState, IconName>> = {
    running: "play",
    next: "right",
    done: "check",
    failed: "warning",
    aborted: "close",
    replaced: "redo",
    skipped: "minus",
  };
  const icon = icons[state];
  return (
    <>
      {icon ? <Icon name={icon} /> : <span className="step-dot" />}
      <span className="hidden-text">{kStateWords[state]}: </span>
    </>
  );
}

function Command({ row, command, label }: { row: StepRow; command: CommandRow; label: string }) {
  const { unit, order } = splitCommand(command.text);
  const isRunning = command.state === "running";
  return (
    <div className="step-command">
      <p>
        {label && <span className="step-label number">{label}</span>}
        {(unit || command.unit) && <strong>{unit || command.unit}</strong>} {order}
      </p>
      {isRunning && command.progress < 0 && <p className="small muted">Steered by hand</p>}
      {isRunning && command.progress >= 0 && (
        <div className="step-progress">
          {(!command.isShared || command.parts > 0) && <Bar share={command.progress} />}
          <span className="small number">{progressText(command)}</span>
        </div>
      )}
      {command.message && (
        <p className={`small ${row.state === "failed" ? "problem" : "muted"}`}>{readableMessage(command.message)}</p>
      )}
    </div>
  );
}

function progressText(command: CommandRow): string {
  const { progress, remaining, robots, robotsDone } = command;
  if (command.isShared) return command.parts > 0 ? `${command.partsDone} of ${command.parts} parts done` : "under way";
  if (robots > 0 && robotsDone === robots) return robots > 1 ? `all ${robots} there` : "there";
  const parts = [`${Math.round(progress * 100)} %`];
  if (remaining >= 0) parts.push(`${distance(remaining)} to go`);
  if (robots > 1) parts.push(`${robotsDone} of ${robots} there`);
  return parts.join(" · ");
}

function StepFoot({ row }: { row: StepRow }) {
  if (row.start < 0 || row.state === "planned" || row.state === "next") {
    return row.state === "next" ? <p className="small step-next">Next</p> : null;
  }
  if (row.state === "running") {
    return (
      <p className="small muted number">
        since {duration(row.start)}
        {row.arrival >= 0 ? ` · arrives about ${duration(row.arrival)}` : ""}
      </p>
    );
  }
  return (
    <p className="small muted number">
      {kStateWords[row.state]} · {duration(row.start)} to {duration(row.end)} · took {duration(row.end - row.start)}
    </p>
  );
}

interface StepMenuProps {
  row: StepRow;
  at: Element;
  mayOrder: boolean;
  hasEnded: boolean;
  onClose: () => void;
}

function StepMenu({ row, at, mayOrder, hasEnded, onClose }: StepMenuProps) {
  const session = useSession();
  const isPlanned = row.step !== kStepOfOrder;
  const entries: MenuEntry[] = [];
  if (isPlanned) {
    entries.push({
      id: "jump",
      label: row.state === "running" ? "Begin this step anew" : "Jump to this step",
      icon: "right",
      detail: hasEnded ? "The mission has ended: restart it first" : "Steps between are left out",
      isDisabled: !mayOrder || hasEnded,
      run: () => control(session, Control_Action.JUMP, row.step),
    });
  }
  if (row.document) {
    entries.push({
      id: "text",
      label: "Show in the text",
      icon: "text",
      detail: `${row.document}:${row.line}`,
      run: () => session.ui.set("reveal", { document: row.document, line: row.line }),
    });
  }
  entries.push({
    id: "map",
    label: "Show its units on the map",
    icon: "map",
    run: () =>
      unitPlace(
        session,
        row.commands.map((command) => command.unit),
      ),
  });
  return <MenuAt at={at} label={nameOf(row)} groups={[{ entries }]} onClose={onClose} />;
}
