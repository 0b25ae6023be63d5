// One try at a time, and its answer only beside the conditions that it answers.
import type { FailsafeTrial } from "../../core/protocol.ts";

/** What would happen, or why that can't be said. */
export type Answer = { trial: FailsafeTrial } | { error: string };

export interface Trying {
  isUnderWay: boolean;
  /** `of` which conditions, by `keyOf`. */
  answer: { of: string; is: Answer } | null;
}

export const kNothingTried: Trying = { isUnderWay: false, answer: null };
export const kUnderWay: Trying = { isUnderWay: true, answer: null };

/** The same for the same conditions alone; nothing is like those that can't be tried. */
export function keyOf(order: object | undefined): string {
  return order ? JSON.stringify(order) : "";
}

/** Without an answer to other conditions than those that stand there now. */
export function kept(trying: Trying, now: string): Trying {
  return trying.answer === null || trying.answer.of === now ? trying : { ...trying, answer: null };
}
