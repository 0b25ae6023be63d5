// The list of the mission's steps as a person sees it: what is planned, how far each has come, what runs now.
import { type Plan, type Status, Status_Mode, Status_Outcome, type Status_Step } from "../../core/protocol.ts";

export const kStepOfOrder = 0xffffffff; // step of an order

export type StepState = "planned" | "next" | "running" | "done" | "failed" | "aborted" | "replaced" | "skipped";

export interface CommandRow {
  text: string;
  unit: string;
  state: StepState;
  progress: number; // 0..1
  remaining: number; // [m]; negative: unknown
  arrival: number; // run time; negative: unknown
  robots: number;
  robotsDone: number;
  isShared: boolean; // among its robots: who is there says nothing
  parts: number; // that they share; 0: none that could be counted
  partsDone: number;
  message: string;
}

export interface StepRow {
  key: string;
  step: number; // index into the plan; kTyped: typed
  label: string;
  state: StepState;
  commands: CommandRow[];
  progress: number;
  start: number; // run time; negative: not begun
  end: number; // run time; negative: not ended
  arrival: number; // of the last of its commands; negative: unknown
  document: string;
  line: number; // from 1; 0: nowhere
}

/** Whether both read alike: a long list is drawn anew only where it differs, many times a second while time is scrubbed. */
export function isSameRow(a: StepRow, b: StepRow): boolean {
  const { commands, ...rest } = a;
  const { commands: others, ...other } = b;
  return (
    isSame(rest, other) && commands.length === others.length && commands.every((one, i) => isSame(one, others[i]!))
  );
}

/** Of texts and numbers. */
function isSame<Flat extends object>(a: Flat, b: Flat): boolean {
  for (const key in a) if (!Object.is(a[key], b[key])) return false;
  return true;
}

const kStates: Record<Status_Outcome, StepState> = {
  [Status_Outcome.PENDING]: "planned",
  [Status_Outcome.UNDER_WAY]: "running",
  [Status_Outcome.DONE]: "done",
  [Status_Outcome.FAILED]: "failed",
  [Status_Outcome.ABORTED]: "aborted",
  [Status_Outcome.REPLACED]: "replaced",
  [Status_Outcome.SKIPPED]: "skipped",
};

/** Planned steps in their order, each with its latest run; typed commands stand behind the step they came after. */
export function stepRows(plan: Plan | undefined, status: Status | undefined): StepRow[] {
  const latest = new Map<number, Status_Step>();
  const typedAfter = new Map<number, StepRow[]>();
  let before = -1;
  (status?.steps ?? []).forEach((step, i) => {
    if (step.step === kStepOfOrder) {
      const rows = typedAfter.get(before) ?? [];
      rows.push(rowOf(step, `typed-${i}`));
      typedAfter.set(before, rows);
    } else {
      latest.set(step.step, step);
      before = step.step;
    }
  });
  const rows: StepRow[] = [...(typedAfter.get(-1) ?? [])];
  (plan?.steps ?? []).forEach((planned, index) => {
    const run = latest.get(index);
    const row: StepRow = run
      ? rowOf(run, `step-${index}`)
      : {
          key: `step-${index}`,
          step: index,
          label: planned.label,
          state: "planned",
          commands: planned.commands.map((command) => plannedCommand(command.text, command.unit)),
          progress: 0,
          start: -1,
          end: -1,
          arrival: -1,
          document: planned.document,
          line: planned.line,
        };
    row.document = planned.document;
    row.line = planned.line;
    if (isNext(index, row.state, status)) row.state = "next";
    rows.push(row, ...(typedAfter.get(index) ?? []));
  });
  return rows;
}

/** Commands that are being carried out at this moment, typed ones too. */
export function runningNow(status: Status | undefined): CommandRow[] {
  return (status?.steps ?? [])
    .filter((step) => step.outcome === Status_Outcome.UNDER_WAY)
    .flatMap((step) => step.commands.filter((command) => command.outcome === Status_Outcome.UNDER_WAY).map(commandOf));
}

/** Share of the planned steps that are behind us, 0..1. */
export function missionProgress(rows: readonly StepRow[]): number {
  const planned = rows.filter((row) => row.step !== kStepOfOrder);
  if (planned.length === 0) return 0;
  const weight = planned.reduce(
    (sum, row) => sum + (isBehind(row.state) ? 1 : row.state === "running" ? row.progress : 0),
    0,
  );
  return weight / planned.length;
}

/** Nothing of it is left to do: done, or passed over on purpose. */
function isBehind(state: StepState): boolean {
  return state === "done" || state === "replaced" || state === "skipped";
}

export const kStateWords: Record<StepState, string> = {
  planned: "Planned",
  next: "Next",
  running: "Running",
  done: "Done",
  failed: "Failed",
  aborted: "Aborted",
  replaced: "Replaced",
  skipped: "Skipped",
};

/** `UNIT scouts MOVETO X` is shown as its unit (or its robots) and the rest, which is what differs from line to line. */
export function splitCommand(text: string): { unit: string; order: string } {
  const robots = /^\s*(ROBOTS?\s+\d[\d\s,-]*?)\s+([A-Z][\s\S]*)$/i.exec(text);
  if (robots) return { unit: (robots[1] as string).toLowerCase(), order: (robots[2] as string).trim() };
  const match = /^\s*UNIT\s+("[^"]*"|\S+)\s+([\s\S]*)$/i.exec(text);
  return match
    ? { unit: (match[1] as string).replaceAll('"', ""), order: (match[2] as string).trim() }
    : { unit: "", order: text.trim() };
}

function isNext(index: number, state: StepState, status: Status | undefined): boolean {
  if (!status || index !== status.currentStep) return false;
  if (status.mode === Status_Mode.ENDED || status.mode === Status_Mode.NO_MISSION) return false;
  return state !== "running";
}

function rowOf(step: Status_Step, key: string): StepRow {
  const commands = step.commands.map(commandOf);
  const isRunning = step.outcome === Status_Outcome.UNDER_WAY;
  const arrivals = commands.filter((command) => command.state === "running").map((command) => command.arrival);
  return {
    key,
    step: step.step,
    label: step.label,
    state: kStates[step.outcome],
    commands,
    progress:
      commands.length === 0
        ? 0
        : commands.reduce((sum, command) => sum + Math.max(0, command.progress), 0) / commands.length,
    start: step.start,
    end: isRunning || step.outcome === Status_Outcome.PENDING ? -1 : step.end,
    arrival: arrivals.length > 0 && arrivals.every((arrival) => arrival >= 0) ? Math.max(...arrivals) : -1,
    document: "",
    line: 0,
  };
}

function commandOf(command: Status_Step["commands"][number]): CommandRow {
  return {
    text: command.text,
    unit: command.unit,
    state: kStates[command.outcome],
    progress: command.outcome === Status_Outcome.DONE ? 1 : command.progress < 0 ? -1 : Math.min(1, command.progress),
    remaining: command.remaining,
    arrival: command.arrival,
    robots: command.robots,
    robotsDone: command.robotsDone,
    isShared: command.isShared,
    parts: command.parts,
    partsDone: command.partsDone,
    message: command.isHeld ? `waits for ${command.waitsFor}` : command.message,
  };
}

function plannedCommand(text: string, unit: string): CommandRow {
  return {
    text,
    unit,
    state: "planned",
    progress: 0,
    remaining: -1,
    arrival: -1,
    robots: 0,
    robotsDone: 0,
    isShared: false,
    parts: 0,
    partsDone: 0,
    message: "",
  };
}
