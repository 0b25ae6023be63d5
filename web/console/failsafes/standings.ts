// How rows of the table stand, in words: for one robot, or for the one of several that is worst off.
import {
  type FailsafeStandings,
  type FailsafeStandings_Standing,
  type Failsafes_Row,
  FailsafeStandings_State as State,
  Failsafes_Row_Watch as Watch,
} from "../../core/protocol.ts";

export type Tone = "" | "go" | "hold" | "danger" | "accent";

interface StateWord {
  word: string;
  tone: Tone;
}

/** The worse a state, the later it stands here. */
const kByConcern: readonly State[] = [
  State.OTHERS,
  State.OFF,
  State.ARMED,
  State.OVERRULED,
  State.NEAR,
  State.WAITING,
  State.ACTIVE,
];

const kWords: Record<State, StateWord> = {
  [State.OTHERS]: { word: "Not its own", tone: "" },
  [State.OFF]: { word: "Off", tone: "" },
  [State.ARMED]: { word: "Armed", tone: "go" },
  [State.OVERRULED]: { word: "Overruled", tone: "" },
  [State.NEAR]: { word: "Near", tone: "hold" },
  [State.WAITING]: { word: "Waiting", tone: "accent" },
  [State.ACTIVE]: { word: "Active", tone: "danger" },
};

export function stateWord(state: State): StateWord {
  return kWords[state] ?? kWords[State.OTHERS];
}

/** Of a row, among the robots that it is for, the one that is worst off. */
export interface Worst {
  robot: number;
  standing: FailsafeStandings_Standing;
  /** How many are in the same state, and how many robots the row is for. */
  alike: number;
  of: number;
}

/** Nothing where the row is none of these robots', or nothing is known of them yet. */
export function worstOf(
  row: number,
  robots: readonly number[],
  standings: ReadonlyMap<number, FailsafeStandings>,
): Worst | undefined {
  const own = robots.flatMap((robot) => {
    const standing = standings.get(robot)?.rows[row];
    return standing && standing.state !== State.OTHERS ? [{ robot, standing }] : [];
  });
  const concern = ({ standing }: { standing: FailsafeStandings_Standing }) =>
    kByConcern.indexOf(standing.state) * 1000 + standing.used;
  const [worst] = own.toSorted((a, b) => concern(b) - concern(a));
  if (!worst) return undefined;
  const alike = own.filter(({ standing }) => standing.state === worst.standing.state).length;
  return { ...worst, alike, of: own.length };
}

/** How much of what it takes is used up, and why it does not act where one would think so. */
export function standingText(row: Failsafes_Row, standing: FailsafeStandings_Standing, isRealTime: boolean): string {
  const { state } = standing;
  if (state === State.OFF) {
    if (row.watch === Watch.REAL_TIME && !isRealTime) return "looked at in real time only";
    if (row.watch === Watch.VEHICLE) return "looked at of vehicles that are driven only";
    return row.watch === Watch.TELEOPERATED ? "looked at under teleoperation only" : "looked at while the robot runs";
  }
  const measured = row.share > 0 ? batteryText(standing.measure) : measureText(row, standing.measure / 10);
  if (state === State.WAITING) return [measured, "a row above it acts"].filter(Boolean).join(", ");
  if (state !== State.OVERRULED) return measured;
  const isOutside = row.fence !== "" && standing.measure < 0;
  return [measured, isOutside ? "it may only drive nearer" : "an order or the stick has taken over"]
    .filter(Boolean)
    .join(", ");
}

/** `64.2 % left`. `measure`: in thousandths, less than 0 where it is not known. */
function batteryText(measure: number): string {
  return measure < 0 ? "not known, which counts as empty" : `${(measure / 10).toFixed(1)} % left`;
}

/** `3.1 of 5 s`, `for 5.1 s`, `12.3 m to the line`, `0.4 m beyond the line`. */
export function measureText(row: Failsafes_Row, measure: number): string {
  if (row.fence !== "") {
    const metres = Math.abs(measure);
    const shown = metres >= 100 ? metres.toFixed(0) : metres.toFixed(1);
    return measure < 0 ? `${shown} m beyond the line` : `${shown} m to the line`;
  }
  if (measure === 0) return "not now";
  if (measure < row.seconds) return `${measure.toFixed(1)} of ${seconds(row.seconds)}`;
  return `for ${seconds(measure)}`;
}

/** `5 s`, `0.5 s`. */
export function seconds(value: number): string {
  return `${Number(value.toFixed(1))} s`;
}

/** `after 5 s`; empty: at once. */
export function thresholdText(row: Failsafes_Row): string {
  return row.mayLast && row.seconds > 0 ? `after ${seconds(row.seconds)}` : "";
}

/** What stands behind the condition: `Field`, `BELOW 30%`; empty: nothing. */
export function operandOf(row: Failsafes_Row): string {
  return row.share > 0 ? `BELOW ${Number((row.share * 100).toFixed(3))}%` : row.fence;
}

/** What the action makes of the robot. A fence holds it whatever its row says. */
export function doesText(row: Failsafes_Row): string {
  if (row.fence === "" || row.action !== "CONTINUE") return row.does;
  return "what its program wants goes on but for the way out: the fence holds";
}

/** The statement without its first word: `LINK-LOST AFTER 5 RETURN`. */
export function nameOf(row: Failsafes_Row | undefined): string {
  return row?.statement.replace(/^FAILSAFE /, "") ?? "";
}

/** `1 active, 2 armed`, the worst first; empty: no row is the robot's. */
export function summaryText(standings: FailsafeStandings | undefined): string {
  const counts = new Map<State, number>();
  for (const { state } of standings?.rows ?? []) counts.set(state, (counts.get(state) ?? 0) + 1);
  return kByConcern
    .filter((state) => state !== State.OTHERS && counts.has(state))
    .toReversed()
    .map((state) => `${counts.get(state)} ${stateWord(state).word.toLowerCase()}`)
    .join(", ");
}

/** The worst state that any row is in. */
export function worstState(standings: FailsafeStandings | undefined): State {
  const states = (standings?.rows ?? []).map((row) => row.state);
  return kByConcern.findLast((state) => states.includes(state)) ?? State.OTHERS;
}
