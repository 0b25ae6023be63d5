// How far an emergency stop has come, as far as this page can know.
import { type Status, Status_Mode } from "../../core/protocol.ts";

export interface StopState {
  /** "sent": asked for, and nothing is known of it; "stopping": robots still move; "confirmed": each one stands. */
  kind: "none" | "sent" | "stopping" | "confirmed";
  standing: number;
  robots: number;
}

/** `isSilent`: the server does not answer, so that its last word proves nothing about a stop that was sent since. */
export function stopState(status: Status | null, isSent: boolean, isSilent: boolean): StopState {
  const { standing = 0, robots = 0 } = status?.stop ?? {};
  if (status?.mode !== Status_Mode.STOPPED || !status.stop) {
    return { kind: isSent ? "sent" : "none", standing: 0, robots: 0 };
  }
  if (isSent && isSilent) return { kind: "sent", standing, robots };
  return { kind: standing < robots ? "stopping" : "confirmed", standing, robots };
}

/** On the button itself. */
export function stopWords({ kind, standing, robots }: StopState): string {
  switch (kind) {
    case "none":
      return "";
    case "sent":
      return "sent, not confirmed";
    case "stopping":
      return `${standing} of ${robots} stand`;
    case "confirmed":
      return robots === 0 ? "confirmed" : robots === 1 ? "confirmed: it stands" : `confirmed: all ${robots} stand`;
  }
}
