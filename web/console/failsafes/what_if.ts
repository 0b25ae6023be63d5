// What came of conditions that were tried, in words.
import {
  type Failsafes_Row,
  type FailsafeTrial,
  FailsafeStandings_State as State,
  FailsafeTrial_What as What,
} from "../../core/protocol.ts";
import { list } from "../../ui/words/format.ts";
import { doesText, nameOf, seconds } from "./standings.ts";

export interface Moment {
  time: number; // [s]
  row: number;
  text: string;
  acts: boolean;
}

/** What happens, in the order of time; what follows from the same cycle is told once. */
export function moments(trial: FailsafeTrial, rows: readonly Failsafes_Row[]): readonly Moment[] {
  return trial.events.flatMap(({ time, row, what }) => {
    const isWith = (other: What) =>
      trial.events.some((event) => event.what === other && event.row === row && event.time === time);
    if ((what === What.ACTS && isWith(What.MET)) || (what === What.NOT_MET && isWith(What.IS_OVER))) return [];
    const actsAtOnce = what === What.MET && isWith(What.ACTS);
    const text = `${nameOf(rows[row])} ${actsAtOnce ? "is met, and acts" : kHappens[what]}`;
    return [{ time, row, text, acts: actsAtOnce || what === What.ACTS }];
  });
}

const kHappens: Record<What, string> = {
  [What.MET]: "is met, and waits",
  [What.NOT_MET]: "is no longer met",
  [What.ACTS]: "acts",
  [What.GIVES_WAY]: "gives way",
  [What.IS_OVER]: "is over",
  [What.LETS_IN]: "lets it in: it begins outside, and may only come nearer",
};

/** The row that acts at the end, else the one that did last. */
export function verdict(trial: FailsafeTrial, rows: readonly Failsafes_Row[]): string {
  const active = trial.rows.findIndex((row) => row.state === State.ACTIVE);
  if (active >= 0) return `${nameOf(rows[active])} acts.`;
  const acted = trial.events.findLast((event) => event.what === What.ACTS);
  if (acted) return `${nameOf(rows[acted.row])} acts, and is over again.`;
  return "No row acts.";
}

/** What the row that acts at the end makes the robot do; empty: none acts then. */
export function doing(trial: FailsafeTrial, rows: readonly Failsafes_Row[]): string {
  const row = rows.find((_, i) => trial.rows[i]?.state === State.ACTIVE);
  return row ? doesText(row) : "";
}

/** What becomes of the robot. */
export function ending(trial: FailsafeTrial): string {
  const { stood, lastRoom } = trial;
  const where = `${metres(trial.drivenTo)} from where it was`;
  const line = lastRoom === undefined ? "" : `, ${lineText(lastRoom)}`;
  const cut = trial.isCut ? ` Nobody looked any further: that would be too much work.` : "";
  const stopped = trial.hasStopped ? " Its program has ended." : "";
  if (stood !== undefined) return `From ${seconds(stood)} on it stands, ${where}${line}.${stopped}${cut}`;
  return `After ${seconds(trial.seconds)} it drives at ${trial.speed.toFixed(1)} m/s, ${where}${line}.${stopped}${cut}`;
}

/** `2.1 m before the line`, `0.4 m beyond the line`; of a body, by its edge. */
export function lineText(room: number): string {
  const shown = metres(Math.abs(room));
  if (shown === "0.0 m") return "at the line";
  return room < 0 ? `${shown} beyond the line` : `${shown} before the line`;
}

function metres(value: number): string {
  return value >= 100 ? `${value.toFixed(0)} m` : `${value.toFixed(1)} m`;
}

/** Rows that were not met, with how much of what they take was used up; many of which nothing was in one line. */
export function notMet(trial: FailsafeTrial, rows: readonly Failsafes_Row[]): readonly string[] {
  const missed = trial.rows.flatMap(({ state, used }, i) => {
    const isMet = trial.events.some((event) => event.row === i && event.what !== What.NOT_MET);
    return isMet || state === State.OTHERS ? [] : [{ rank: i + 1, row: rows[i], used }];
  });
  const untouched = missed.filter(({ used }) => used === 0).map(({ rank }) => String(rank));
  const isMany = untouched.length > kFew;
  const told = missed.filter(({ used }) => !isMany || used > 0).map(({ row, used }) => `${nameOf(row)} (${used} %)`);
  return isMany ? [...told, `Rows ${list(untouched)} (0 %)`] : told;
}

const kFew = 2;
