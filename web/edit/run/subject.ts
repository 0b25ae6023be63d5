// What of a file runs: a robot or a society of it, or an assemblage in a body that the server gives it.
import { declarationOf } from "../../designer/session/pages.ts";
import type { Declaration } from "../../designer/session/protocol.ts";

const kOrder = ["robot", "society", "assemblage"];

/** All that can run, robots first. */
export function subjectsOf(declarations: readonly Declaration[]): Declaration[] {
  return declarations
    .filter(({ kind }) => kOrder.includes(kind))
    .sort((a, b) => kOrder.indexOf(a.kind) - kOrder.indexOf(b.kind));
}

/** The chosen one; else that of the page, where it is a robot or a society; else the first robot; else the page's. */
export function subjectOf(declarations: readonly Declaration[], chosen: string, page: string): Declaration | undefined {
  const subjects = subjectsOf(declarations);
  const named = (name: string) => subjects.find((one) => one.name === name);
  const drawn = named(declarationOf(page));
  const robot = drawn && drawn.kind !== "assemblage" ? drawn : subjects.find(({ kind }) => kind === "robot");
  return named(chosen) ?? robot ?? drawn ?? subjects.find(({ kind }) => kind === "society") ?? subjects.at(-1);
}
