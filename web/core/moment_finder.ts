// Looks for moments at which something becomes true. The server searches in pieces; this asks for one after the other.
import type { Connection } from "./connection.ts";
import type { Found_One } from "./protocol.ts";
import { Store } from "./store.ts";

const kMost = 1000; // moments: more say nothing
const kPerPiece = 100;

export interface Finding {
  /** What was looked for last; empty: nothing. */
  readonly condition: string;
  readonly isUnderWay: boolean;
  /** Ordered by time. */
  readonly moments: readonly Found_One[];
  /** So far it has been looked [s]. */
  readonly searchedTo: number;
  /** As the server says it; empty: it understands. */
  readonly problem: string;
  /** There are more, which were not looked for. */
  readonly isCut: boolean;
}

export const kNoFinding: Finding = {
  condition: "",
  isUnderWay: false,
  moments: [],
  searchedTo: 0,
  problem: "",
  isCut: false,
};

/**
 * Conditions, as they can be written, to begin with; each with what it says. `state`: one of the robot's, empty where
 * none is known.
 */
export function exampleConditions(robot: number, state: string): (readonly [string, string])[] {
  return [
    ["any robot in contact", "each time one touches something"],
    [`robot ${robot} nearer than 2 m to an obstacle`, "edge to edge, walls as well"],
    ["any robot nearer than 1 m to a robot", "two of them come close"],
    ...(state === "" ? [] : [[`robot ${robot} in state ${state}`, "each time it comes into it"] as const]),
    [`robot ${robot} speed > 1.5`, "over ground [m/s]; any quantity that can be plotted, or a port"],
    [`robot ${robot} formation-error > 5`, "distance from its station [m]"],
    ["any robot farther than 50 m from its goal", "or from a place of the map: from PP-Charlie"],
  ];
}

export class MomentFinder extends Store<{ finding: Finding }> {
  private search = 0;

  constructor(private readonly connection: Pick<Connection, "ask">) {
    super({ finding: kNoFinding });
  }

  /** Over the whole run, from its beginning; what was looked for before is forgotten. */
  async find(condition: string): Promise<void> {
    const search = ++this.search;
    const wanted = condition.trim();
    if (wanted === "") {
      this.set("finding", kNoFinding);
      return;
    }
    this.set("finding", { ...kNoFinding, condition: wanted, isUnderWay: true });
    while (await this.piece(search)) {
      // Once more.
    }
  }

  /** What has been found stays. */
  cancel(): void {
    ++this.search;
    const finding = this.get("finding");
    if (finding.isUnderWay) this.set("finding", { ...finding, isUnderWay: false, isCut: true });
  }

  forget(): void {
    ++this.search;
    this.set("finding", kNoFinding);
  }

  /** @returns whether there is more to look through */
  private async piece(search: number): Promise<boolean> {
    const { condition, searchedTo } = this.get("finding");
    const reply = await this.connection.ask({
      case: "findMoments",
      // Before the first cycle, so that it counts as well.
      value: { condition, from: searchedTo === 0 ? -1 : searchedTo, most: kPerPiece },
    });
    if (search !== this.search) return false;
    const before = this.get("finding");
    if (!reply.ok || reply.result.case !== "found") {
      this.set("finding", { ...before, isUnderWay: false, problem: reply.error || "the server did not answer" });
      return false;
    }
    const { moments: fresh, searchedTo: to, isAll } = reply.result.value;
    const moments = [...before.moments, ...fresh];
    const isCut = moments.length >= kMost && !isAll;
    // A piece that leads nowhere would be asked for again and again.
    const goesOn = !isAll && !isCut && (to > searchedTo || fresh.length > 0);
    this.set("finding", { ...before, moments, searchedTo: Math.max(to, searchedTo), isUnderWay: goesOn, isCut });
    return goesOn && search === this.search;
  }
}

/** The next one after a moment, or the last one before it. */
export function neighbourMoment(
  moments: readonly { readonly time: number }[],
  time: number,
  by: 1 | -1,
): number | undefined {
  const kSame = 1e-6; // s
  if (by > 0) return moments.find((one) => one.time > time + kSame)?.time;
  return moments.findLast((one) => one.time < time - kSame)?.time;
}
