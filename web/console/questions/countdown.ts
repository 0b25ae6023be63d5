import type { Questions_Question, Status } from "../../core/protocol.ts";

export interface Countdown {
  /** Simulated seconds until it answers itself with yes. */
  left: number;
  /** Of the whole time, 1..0. */
  share: number;
  /** The same in seconds of the wall clock; infinite while time stands still. */
  wallLeft: number;
}

/** Nothing where the question waits for ever. */
export function countdown(question: Questions_Question, time: number, status: Status | null): Countdown | undefined {
  const { expires, asked } = question;
  if (expires === undefined) return undefined;
  const left = Math.max(0, expires - time);
  const whole = expires - asked;
  const pace = status && status.speedReached > 0 ? status.speedReached : 0;
  return {
    left,
    share: whole > 0 ? Math.min(1, left / whole) : 0,
    wallLeft: pace > 0 ? left / pace : Number.POSITIVE_INFINITY,
  };
}
