// Probes and breakpoints as the server keeps them with their document: what the pane shows of them, and what has to be told
// to the simulator when names have changed.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Breakpoint } from "../../core/protocol.ts";
import { type Drawing, kResult, type Mark, type MarkSchema } from "../../designer/session/protocol.ts";
import type { DrawnAt, Pin } from "./live_state.ts";
import { targetOf } from "./targets.ts";

export type MarkInit = Exclude<MessageInitShape<typeof MarkSchema>, Mark>;
type ByDocument = Readonly<Record<string, readonly Mark[]>>;

/** What of the page an id of the selection is; nothing: it can't be marked. */
export function markAt(drawing: Drawing, id: string): MarkInit | undefined {
  const target = targetOf(drawing, id);
  if (!target) return undefined;
  const at = { page: drawing.page?.path ?? "", drawn: id };
  if (target.kind === "transition") return { ...at, from: target.from, to: target.to };
  if (target.kind === "state") return { ...at, to: target.name };
  const wire = drawing.wires.find(({ live }) => live === target.live);
  const node = drawing.nodes.some(({ name }) => name === id) ? id : (wire?.from ?? "");
  return node === "" || node === kResult ? undefined : { ...at, node };
}

export function pinsOf(marks: ByDocument): Pin[] {
  return all(marks)
    .filter(([, mark]) => !mark.breakpoint)
    .map(([document, mark]) => ({ ...drawnAt(document, mark), port: mark.port, mark: mark.id }));
}

/** Those of a page; `place` undefined: wherever it runs. */
export function marksOfPage(marks: readonly Mark[], page: string, place: string | undefined): Mark[] {
  return marks.filter((mark) => mark.page === page && !mark.isLost && (place === undefined || mark.place === place));
}

/** The one that breaks at a transition between these states; empty: any. */
export function breakAtTransition(marks: readonly Mark[], from: string, to: string): Mark | undefined {
  return marks.find(({ breakpoint }) => {
    const what = breakpoint?.what;
    return what?.case === "transition" && what.value.from === from && what.value.to === to;
  });
}

/** On the same thing of a page: on the value of a node, or a condition of a transition. */
export function isOnSame(mark: Mark, { node = "", from = "", to = "", trigger = "" }: MarkInit): boolean {
  return mark.node === node && mark.from === from && mark.to === to && mark.trigger === trigger;
}

/** When the value becomes this. */
export function breaksWhen({ breakpoint }: Mark, value: "true" | "false"): boolean {
  return breakpoint?.what.case === "condition" && breakpoint.what.value.value === value;
}

/** Breakpoints of an earlier server, which the simulator that runs now was not told of. */
export function untoldMarks(marks: ByDocument): { document: string; mark: Mark }[] {
  return all(marks).flatMap(([document, mark]) => (mark.breakpoint?.id === 0 ? [{ document, mark }] : []));
}

/** Where breakpoints are drawn, by their ids. */
export function drawnAtOf(marks: ByDocument): Map<number, DrawnAt> {
  return new Map(
    all(marks).flatMap(([document, mark]) =>
      mark.breakpoint ? [[mark.breakpoint.id, drawnAt(document, mark)] as const] : [],
    ),
  );
}

/** The breakpoints of the simulator that are called otherwise in the text as it stands, as they have to be. */
export function renamedBreakpoints(marks: readonly Mark[], known: readonly Breakpoint[]): Breakpoint[] {
  return marks.flatMap(({ breakpoint, isLost }) => {
    const now = known.find(({ id }) => id === breakpoint?.id);
    if (!breakpoint || !now || isLost || isSame(breakpoint, now)) return [];
    return [{ ...now, what: breakpoint.what }];
  });
}

/** Marks of breakpoints that the simulator does not have any more: somebody took them away elsewhere. */
export function endedMarks(marks: readonly Mark[], known: readonly Breakpoint[]): Mark[] {
  return marks.filter(
    ({ breakpoint }) => breakpoint && breakpoint.id !== 0 && !known.some(({ id }) => id === breakpoint.id),
  );
}

function all(marks: ByDocument): (readonly [string, Mark])[] {
  return Object.entries(marks).flatMap(([document, list]) => list.map((mark) => [document, mark] as const));
}

function drawnAt(document: string, { page, drawn, isLost }: Mark): DrawnAt {
  return { document, page, id: drawn, isLost };
}

function isSame({ what: a }: Breakpoint, { what: b }: Breakpoint): boolean {
  if (a.case === "transition" && b.case === "transition") {
    return a.value.sequence === b.value.sequence && a.value.from === b.value.from && a.value.to === b.value.to;
  }
  return a.case === "condition" && b.case === "condition" && a.value.port === b.value.port;
}
