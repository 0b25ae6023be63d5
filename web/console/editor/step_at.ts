import type { Plan } from "../../core/protocol.ts";

/** Index of the step that the line belongs to: the last one that begins there or above; nothing before the first. */
export function stepAtLine(plan: Plan | null, document: string, line: number): number | undefined {
  let found: number | undefined;
  let best = 0;
  (plan?.steps ?? []).forEach((step, index) => {
    if (step.document !== document || step.line > line || step.line < best) return;
    best = step.line;
    found = index;
  });
  return found;
}
