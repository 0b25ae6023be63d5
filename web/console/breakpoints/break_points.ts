// Breakpoints as they are set on what is drawn, and in words; how they and what has stopped the run are told.
import type { MessageInitShape } from "@bufbuild/protobuf";
import { spokenPath } from "../../core/port_words.ts";
import {
  type Breakpoint,
  type BreakpointSchema,
  Breakpoint_Condition_Comparison as Comparison,
  type Halted_Hit,
} from "../../core/protocol.ts";

export type BreakpointInit = MessageInitShape<typeof BreakpointSchema>;

/** `sequence`: path of the sequence in the program, empty: that of the only one. */
export function atTransition(sequence: string, from: string, to: string): BreakpointInit {
  return { what: { case: "transition", value: { sequence, from, to } } };
}

export function atCondition(port: string, comparison: Comparison, value: string): BreakpointInit {
  return { what: { case: "condition", value: { port, comparison, value } } };
}

/** As moments are found by. */
export function atSentence(sentence: string): BreakpointInit {
  return { what: { case: "sentence", value: sentence } };
}

export const kComparisons: readonly (readonly [Comparison, string])[] = [
  [Comparison.EQUAL, "="],
  [Comparison.NOT_EQUAL, "≠"],
  [Comparison.LESS, "<"],
  [Comparison.LESS_OR_EQUAL, "≤"],
  [Comparison.GREATER, ">"],
  [Comparison.GREATER_OR_EQUAL, "≥"],
];

export function comparisonSign(comparison: Comparison): string {
  return kComparisons.find(([one]) => one === comparison)?.[1] ?? "=";
}

/** In a list: `Searching → Acquiring`, `Searching: near is true`. */
export function breakpointText({ what }: Pick<Breakpoint, "what">): string {
  if (what.case === "transition") {
    const { from, to } = what.value;
    return `${from || "any state"} → ${to || "any state"}`;
  }
  if (what.case === "sentence") return what.value;
  if (what.case !== "condition") return "nothing";
  const { port, comparison, value } = what.value;
  if (comparison === Comparison.EQUAL && (value === "true" || value === "false"))
    return `${spokenPath(port)} is ${value}`;
  return `${spokenPath(port)} ${comparisonSign(comparison)} ${value}`;
}

/** What has stopped the run: `robot 1: Searching: near is true`, `robot 1: Forage goes from Searching to Acquiring`. */
export function hitText({
  robot,
  text,
  sequence,
  from,
  to,
  port,
  value,
}: Omit<Halted_Hit, "breakpoint" | "$typeName">): string {
  if (port !== "") return `robot ${robot}: ${spokenPath(port)} is ${value}`;
  if (sequence === "") return text;
  return `robot ${robot}: ${spokenPath(sequence)} goes from ${from} to ${to}`;
}

/** Where a hit is drawn: the sequence or the port's node, to be found among the places of pages. */
export function pathOfHit(hit: Pick<Halted_Hit, "sequence" | "port">): string {
  return hit.sequence || hit.port;
}
