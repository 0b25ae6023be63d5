// How far an emergency stop has come, as far as this page can know.
import { type Status, Status_Mode } from "../../core/protocol.ts";

export interface StopState {
  /** "sent": asked for, and nothing is known of it; "stopping": robots still move; "confirmed": each one stands. */
  kind: "none" | "sent" | "stopping" | "confirmed";
  standing: number;
  robots: number;
  /** Machines that have not said that their robots stand. */
  unreached: readonly string[];
}

/** `isSilent`: the server does not answer, so that its last word proves nothing about a stop that was sent since. */
export function stopState(status: Status | null, isSent: boolean, isSilent: boolean): StopState {
  const { standing = 0, robots = 0, unreached = [] } = status?.stop ?? {};
  if (status?.mode !== Status_Mode.STOPPED || !status.stop) {
    return { kind: isSent ? "sent" : "none", standing: 0, robots: 0, unreached: [] };
  }
  if (isSent && isSilent) return { kind: "sent", standing, robots, unreached };
  const isConfirmed = standing >= robots && unreached.length === 0;
  return { kind: isConfirmed ? "confirmed" : "stopping", standing, robots, unreached };
}

/** Whether the server has taken the stop: what comes of it is the run's, and a release ends it. */
export function isTaken({ kind }: StopState): boolean {
  return kind === "stopping" || kind === "confirmed";
}

/** On the button itself. */
export function stopWords({ kind, standing, robots, unreached }: StopState): string {
  switch (kind) {
    case "none":
      return "";
    case "sent":
      return "sent, not confirmed";
    case "stopping":
      return standing < robots ? `${standing} of ${robots} stand` : `not confirmed by ${unreached.join(", ")}`;
    case "confirmed":
      return robots === 0 ? "confirmed" : robots === 1 ? "confirmed: it stands" : `confirmed: all ${robots} stand`;
  }
}
