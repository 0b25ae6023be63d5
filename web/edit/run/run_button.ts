// What the large button does, as things stand.
import { Status_Mode } from "../../core/protocol.ts";

export interface Situation {
  /** Connected to the simulator. */
  readonly isConnected: boolean;
  /** A recording is shown: nothing can run beside it. */
  readonly isRecording: boolean;
  /** Another moment of the run than now is shown. */
  readonly isElsewhen: boolean;
  /** An answer to Try is awaited. */
  readonly isBusy: boolean;
  /** Errors in the text that is shown. */
  readonly errors: number;
  /** Whether there is something in the file that can run. */
  readonly hasSubject: boolean;
  /** What the simulator holds is what was tried from here. */
  readonly isOurs: boolean;
  /** The text is still the one that was tried. */
  readonly isCurrent: boolean;
  /** So is what runs, how many and where. */
  readonly isSameSetup: boolean;
  readonly mode: Status_Mode;
}

export type RunAct = "try" | "execute" | "resume" | "pause" | "release" | "problems" | "now" | "none";

export interface RunButton {
  readonly act: RunAct;
  readonly label: string;
  readonly hint: string;
}

export function runButton(now: Situation): RunButton {
  if (!now.isConnected) return { act: "none", label: "Run", hint: "There is no connection to the simulator" };
  if (now.isBusy) return { act: "none", label: "Compiling…", hint: "The configuration is compiled" };
  if (now.isRecording)
    return { act: "none", label: "Recording", hint: "A recorded run is shown: nothing else can run" };
  if (now.isElsewhen) return { act: "now", label: "Back to now", hint: "The drawing shows another moment of the run" };
  if (now.mode === Status_Mode.STOPPED) {
    return { act: "release", label: "Release", hint: "An emergency stop holds all robots" };
  }
  if (now.isOurs && isMoving(now.mode)) return { act: "pause", label: "Pause", hint: "Time stands still" };
  if (now.isOurs && now.isCurrent && now.mode === Status_Mode.PAUSED) {
    return { act: "resume", label: "Go on", hint: "Time goes on" };
  }
  if (now.errors > 0) {
    return { act: "problems", label: "Run", hint: "It does not compile yet: shows what is wrong" };
  }
  if (!now.hasSubject) return { act: "none", label: "Run", hint: "There is no assemblage and no robot that could run" };
  if (now.isOurs && now.isCurrent && now.mode === Status_Mode.READY) {
    return { act: "execute", label: "Run", hint: "Robots start in the simulator" };
  }
  const isOther = !now.isOurs && isMoving(now.mode);
  return {
    act: "try",
    label: "Run",
    hint: isOther ? "Takes the place of the mission that runs" : "Robots start in the simulator",
  };
}

export function isMoving(mode: Status_Mode): boolean {
  return mode === Status_Mode.RUNNING || mode === Status_Mode.WAITING;
}

/** Whether the text has changed under what runs, and nothing else: its robots can go on with what it says now. */
export function offersTakeOver(now: Situation): boolean {
  const runs = isMoving(now.mode) || now.mode === Status_Mode.PAUSED;
  return !now.isElsewhen && now.isOurs && now.isSameSetup && !now.isCurrent && now.errors === 0 && !now.isBusy && runs;
}

/** Whether the text has changed under what runs: then a second button begins anew with the change. */
export function offersChange(now: Situation): boolean {
  return !now.isElsewhen && now.isOurs && !now.isCurrent && now.errors === 0 && !now.isBusy && isMoving(now.mode);
}
