// The state of the run in a word.
import { type Status, Status_Mode, Status_Outcome } from "../../core/protocol.ts";

export interface RunState {
  word: string;
  tone: "" | "go" | "hold" | "danger" | "accent";
}

/** The mission is open, and its robots are not there yet. An emergency stop is shown all the same. */
export function isGettingReady(status: Status | null | undefined): boolean {
  return status?.isBeingMade === true && status.mode !== Status_Mode.STOPPED;
}

export function stateOf(status: Status | undefined, link: "open" | "silent" | "closed", errors = 0): RunState {
  if (link === "closed") return { word: "No connection", tone: "danger" };
  if (link === "silent") return { word: "No answer", tone: "danger" };
  if (isGettingReady(status)) return { word: "Getting ready", tone: "" };
  switch (status?.mode) {
    case Status_Mode.READY:
      return { word: "Ready", tone: "accent" };
    case Status_Mode.RUNNING:
      return { word: "Running", tone: "go" };
    case Status_Mode.PAUSED:
      return { word: "Paused", tone: "hold" };
    case Status_Mode.WAITING:
      return { word: "Waits for you", tone: "hold" };
    case Status_Mode.STOPPED:
      return { word: "Emergency stop", tone: "danger" };
    case Status_Mode.ENDED:
      return status.outcome === Status_Outcome.DONE
        ? { word: "Done", tone: "go" }
        : status.outcome === Status_Outcome.FAILED
          ? { word: "Failed", tone: "danger" }
          : { word: status.outcome === Status_Outcome.ABORTED ? "Aborted" : "Ended", tone: "hold" };
    default:
      return errors > 0 ? { word: "Has errors", tone: "danger" } : { word: "No mission", tone: "" };
  }
}
