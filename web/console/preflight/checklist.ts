// The checklist as people go through it, and what is missing before it can be signed.
import type { MessageInitShape } from "@bufbuild/protobuf";
import {
  type Preflight,
  type Preflight_Item,
  Preflight_Result as Result,
  type SignPreflightSchema,
} from "../../core/protocol.ts";
import { count, list } from "../../ui/words/format.ts";

export type Order = MessageInitShape<typeof SignPreflightSchema>;

interface ResultWord {
  word: string;
  tone: "" | "go" | "hold" | "danger";
}

const kWords: Record<Result, ResultWord> = {
  [Result.PASS]: { word: "Pass", tone: "go" },
  [Result.WARN]: { word: "Warning", tone: "hold" },
  [Result.FAIL]: { word: "Failed", tone: "danger" },
  [Result.UNKNOWN]: { word: "Unknown", tone: "" },
};

/** The worse a result, the later it stands here. */
const kByConcern: readonly Result[] = [Result.PASS, Result.UNKNOWN, Result.WARN, Result.FAIL];

export function resultWord(result: Result): ResultWord {
  return kWords[result] ?? kWords[Result.UNKNOWN];
}

/** What belongs to the mission, or to one vehicle. */
export interface Group {
  key: string;
  title: string;
  /** Below the title: what kind of vehicle it is, and whose body. */
  about: string;
  items: readonly Preflight_Item[];
  worst: Result;
}

export function groupsOf(checklist: Preflight, nameOf: (robot: number) => string): readonly Group[] {
  const group = (key: string, title: string, about: string): Group => {
    const items = checklist.items.filter((item) => item.vehicle === key);
    return { key, title, about, items, worst: worstOf(items) };
  };
  const vehicles = checklist.vehicles.map((vehicle) => {
    const kind = vehicle.kind === vehicle.name ? "" : vehicle.kind;
    const simulated = vehicle.isSimulated ? "simulated: nothing real moves" : "";
    const robots = vehicle.robots.length > 0 ? `body of ${list(vehicle.robots.map(nameOf))}` : "";
    return group(vehicle.name, `Vehicle ${vehicle.name}`, [kind, robots, simulated].filter(Boolean).join(", "));
  });
  return [group("", "The mission", ""), ...vehicles].filter(({ key, items }) => key !== "" || items.length > 0);
}

export function worstOf(items: readonly Preflight_Item[]): Result {
  const worst = Math.max(0, ...items.map(({ result }) => kByConcern.indexOf(result)));
  return kByConcern[worst] ?? Result.UNKNOWN;
}

/** `1 failed, 2 unknown, 14 pass`, the worst first. */
export function tally(items: readonly Preflight_Item[]): string {
  return kByConcern
    .toReversed()
    .map((result) => [result, items.filter((item) => item.result === result).length] as const)
    .filter(([, n]) => n > 0)
    .map(([result, n]) =>
      result === Result.WARN ? count(n, "warning") : `${n} ${resultWord(result).word.toLowerCase()}`,
    )
    .join(", ");
}

/** As somebody fills it in. */
export interface Draft {
  by: string;
  confirmed: ReadonlySet<string>;
  /** Why somebody starts all the same, by the item that has failed. */
  because: Readonly<Record<string, string>>;
}

export const kBlank: Draft = { by: "", confirmed: new Set(), because: {} };

export function failedIn(checklist: Preflight): readonly Preflight_Item[] {
  return checklist.items.filter((item) => item.result === Result.FAIL);
}

/** What is missing before it can be signed, as sentences; none: it can. */
export function missingIn(checklist: Preflight, draft: Draft): readonly string[] {
  const open = checklist.manual.filter(({ id }) => !draft.confirmed.has(id)).length;
  const failed = failedIn(checklist).filter(({ id }) => (draft.because[id] ?? "").trim() === "").length;
  return [
    checklist.lookedAt === 0 ? "The vehicles are still being looked at." : "",
    failed > 0 ? `${count(failed, "item")} ${failed === 1 ? "has" : "have"} failed, and no reason is given.` : "",
    open > 0 ? `${count(open, "item")} ${open === 1 ? "is" : "are"} not confirmed.` : "",
    draft.by.trim() === "" ? "Nobody's name stands below it." : "",
  ].filter((line) => line !== "");
}

export function orderOf(checklist: Preflight, draft: Draft): Order {
  return {
    by: draft.by.trim(),
    confirmed: checklist.manual.filter(({ id }) => draft.confirmed.has(id)).map(({ id }) => id),
    accepted: failedIn(checklist).map(({ id }) => ({ item: id, because: (draft.because[id] ?? "").trim() })),
  };
}

/** How many things want somebody, for the panel's button. */
export function attention(checklist: Preflight | null): number {
  if (!checklist?.isNeeded || checklist.signedBy !== "") return 0;
  return Math.max(1, failedIn(checklist).length);
}
