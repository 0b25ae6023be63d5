// What a person asks of the table, and what came of it, in words.
import type { MessageInitShape } from "@bufbuild/protobuf";
import {
  type Failsafes_Row,
  type FailsafeTrial,
  FailsafeStandings_State as State,
  type TryFailsafesSchema,
  FailsafeTrial_What as What,
} from "../../core/protocol.ts";
import { nameOf, seconds } from "./standings.ts";

/** Conditions with a length, by the words of the table. */
export type Lasting = "LINK-LOST" | "IN-CONTACT" | "STUCK";
export const kLasting: readonly (readonly [Lasting, string])[] = [
  ["LINK-LOST", "Link lost"],
  ["IN-CONTACT", "In contact"],
  ["STUCK", "Stuck"],
];

export interface Conditions {
  /** How long [s]; nothing: it isn't so. */
  lasting: Partial<Record<Lasting, number>>;
  fence: AtFence | null;
  speed: number; // [m/s]
}

export interface AtFence {
  row: number;
  side: "inside" | "outside";
  distance: number; // from the line [m]
  bearing: number; // from straight out, counter-clockwise [deg]
  beginsThere: boolean;
}

/** As the server takes them. */
export const kMost = { seconds: 600, speed: 50, distance: 1000, bearing: 360 };

/** Where one begins: the highest row would be met. */
export function firstConditions(rows: readonly Failsafes_Row[]): Conditions {
  const [first] = rows;
  const none: Conditions = { lasting: {}, fence: null, speed: 1 };
  if (!first) return none;
  if (first.fence !== "") return { ...none, fence: firstFence(rows) };
  return { ...none, lasting: { [first.condition]: firstSeconds(rows, first.condition) } };
}

export function firstFence(rows: readonly Failsafes_Row[]): AtFence | null {
  const row = rows.findIndex((one) => one.fence !== "");
  return row < 0 ? null : { row, side: "inside", distance: 5, bearing: 0, beginsThere: false };
}

/** A second more than the longest row of this condition takes. */
export function firstSeconds(rows: readonly Failsafes_Row[], condition: string): number {
  const longest = Math.max(0, ...rows.filter((row) => row.condition === condition).map((row) => row.seconds));
  return Math.min(kMost.seconds, Math.ceil(longest) + 1);
}

/** What can be asked of this table. */
export function askable(rows: readonly Failsafes_Row[]): readonly (readonly [Lasting, string])[] {
  return kLasting.filter(([condition]) => rows.some((row) => row.condition === condition));
}

export function fences(rows: readonly Failsafes_Row[]): readonly (readonly [string, string])[] {
  return rows.flatMap((row, i) => (row.fence === "" ? [] : [[String(i), `${i + 1}. ${row.fence}`] as const]));
}

export function orderOf(robot: number, asked: Conditions): MessageInitShape<typeof TryFailsafesSchema> {
  const { lasting, fence, speed } = asked;
  return {
    robot,
    linkLost: lasting["LINK-LOST"] ?? 0,
    inContact: lasting["IN-CONTACT"] ?? 0,
    stuck: lasting.STUCK ?? 0,
    speed,
    ...(fence && {
      fence: {
        row: fence.row,
        depth: fence.side === "inside" ? fence.distance : -fence.distance,
        bearing: (fence.bearing * Math.PI) / 180,
        beginsThere: fence.side === "outside" && fence.beginsThere,
      },
    }),
  };
}

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
  return rows.find((_, i) => trial.rows[i]?.state === State.ACTIVE)?.does ?? "";
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

/** Rows that were not met, with how much of what they take was used up. */
export function notMet(trial: FailsafeTrial, rows: readonly Failsafes_Row[]): readonly string[] {
  return trial.rows.flatMap((standing, i) => {
    const isMet = trial.events.some((event) => event.row === i && event.what !== What.NOT_MET);
    if (isMet || standing.state === State.OTHERS) return [];
    return [`${nameOf(rows[i])} (${standing.used} %)`];
  });
}
