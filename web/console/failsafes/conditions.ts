// What a person asks of the table: conditions as they are typed, and as the server takes them.
import type { MessageInitShape } from "@bufbuild/protobuf";
import {
  type FailsafeStandings,
  type Failsafes_Bounds,
  type Failsafes_Row,
  FailsafeStandings_State as State,
  type TryFailsafesSchema,
} from "../../core/protocol.ts";
import { readNumber } from "../../ui/words/read_number.ts";

export type Order = MessageInitShape<typeof TryFailsafesSchema>;

/** `Link lost`, of `LINK-LOST`. */
export function labelOf(condition: string): string {
  if (condition === "BATTERY") return "Battery empty";
  const words = condition.toLowerCase().replaceAll("-", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export interface Conditions<Amount = number> {
  /** How long, by the table's words for conditions that last [s]; those that aren't there aren't so. */
  lasting: Readonly<Record<string, Amount>>;
  fence: AtFence<Amount> | null;
  speed: Amount; // [m/s]
}

export interface AtFence<Amount = number> {
  row: number;
  side: "inside" | "outside";
  distance: Amount; // from the line [m]
  bearing: Amount; // from straight out, counter-clockwise [deg]
  beginsThere: boolean;
}

/** As they are typed. */
export type Draft = Conditions<string>;

export interface Bounds {
  min: number;
  max: number;
}

/** What the server takes, in the units in which it is typed. */
export interface Limits {
  seconds: Bounds;
  speed: Bounds;
  distance: Bounds;
  bearing: Bounds;
}

/** Nothing, before the server has said what it takes. */
export function limitsOf(told: Failsafes_Bounds | null): Limits {
  const { seconds = 0, speed = 0, depth = 0, bearing = 0 } = told ?? {};
  const turn = Math.round((bearing * 180) / Math.PI);
  return {
    seconds: { min: 0, max: seconds },
    speed: { min: 0, max: speed },
    distance: { min: 0, max: depth },
    bearing: { min: -turn, max: turn },
  };
}

/** A row that guards the robot, and its place in the table. */
export interface OwnRow {
  index: number;
  row: Failsafes_Row;
}

/** Before anything is known of the robot, the rows that guard all. */
export function ownRows(rows: readonly Failsafes_Row[], standings: FailsafeStandings | undefined): readonly OwnRow[] {
  return rows.flatMap((row, index) => {
    const state = standings?.rows[index]?.state;
    const isOwn = state === undefined ? row.robots === "" : state !== State.OTHERS;
    return isOwn ? [{ index, row }] : [];
  });
}

/** Where one begins: the highest row would be met. */
export function firstDraft(own: readonly OwnRow[], limits: Limits): Draft {
  const none: Draft = { lasting: {}, fence: null, speed: "1" };
  const [first] = own;
  if (!first) return none;
  if (first.row.fence !== "") return { ...none, fence: firstFence(own) };
  return { ...none, lasting: { [first.row.condition]: firstSeconds(own, first.row.condition, limits) } };
}

export function firstFence(own: readonly OwnRow[]): AtFence<string> | null {
  const first = own.find(({ row }) => row.fence !== "");
  return first ? { row: first.index, side: "inside", distance: "5", bearing: "0", beginsThere: false } : null;
}

/** A second more than the longest row of this condition takes. */
export function firstSeconds(own: readonly OwnRow[], condition: string, { seconds }: Limits): string {
  const longest = Math.max(0, ...own.filter(({ row }) => row.condition === condition).map(({ row }) => row.seconds));
  return String(Math.min(seconds.max, Math.ceil(longest) + 1));
}

/** What can be asked of these rows. */
export function askable(own: readonly OwnRow[]): readonly string[] {
  return [...new Set(own.flatMap(({ row }) => (row.mayLast ? [row.condition] : [])))];
}

export function fences(own: readonly OwnRow[]): readonly (readonly [string, string])[] {
  return own.flatMap(({ index, row }) =>
    row.fence === "" ? [] : [[String(index), `${index + 1}. ${row.fence}`] as const],
  );
}

/** Of what was asked of another robot, what can be asked of this one. */
export function fitted(draft: Draft, own: readonly OwnRow[]): Draft {
  const lasting: Record<string, string> = {};
  for (const condition of askable(own)) {
    const seconds = draft.lasting[condition];
    if (seconds !== undefined) lasting[condition] = seconds;
  }
  const first = firstFence(own);
  const isOwn = own.some(({ index, row }) => index === draft.fence?.row && row.fence !== "");
  const fence = draft.fence && first && (isOwn ? draft.fence : { ...draft.fence, row: first.row });
  return { ...draft, lasting, fence };
}

/** The names of those numbers that are none, or out of bounds. */
export function wrongIn(draft: Draft, limits: Limits): readonly string[] {
  return amounts(draft, limits).flatMap(([name, text, { min, max }]) =>
    readNumber(text, min, max).problem === undefined ? [] : [name],
  );
}

function amounts({ lasting, fence, speed }: Draft, limits: Limits): readonly (readonly [string, string, Bounds])[] {
  return [
    ...Object.entries(lasting).map(([condition, text]) => [labelOf(condition), text, limits.seconds] as const),
    ...(fence
      ? [["Distance", fence.distance, limits.distance] as const, ["Heading", fence.bearing, limits.bearing] as const]
      : []),
    ["Speed", speed, limits.speed],
  ];
}

/** What is tried with the robot; nothing while a number is wrong. */
export function orderOf(robot: number, draft: Draft, limits: Limits): Order | undefined {
  if (wrongIn(draft, limits).length > 0) return undefined;
  const { lasting, fence, speed } = draft;
  const amount = (text: string) => readNumber(text).number;
  return {
    robot,
    lasting: Object.entries(lasting).map(([condition, text]) => ({ condition, seconds: amount(text) })),
    speed: amount(speed),
    ...(fence && {
      fence: {
        row: fence.row,
        depth: fence.side === "inside" ? amount(fence.distance) : -amount(fence.distance),
        bearing: (amount(fence.bearing) * Math.PI) / 180,
        beginsThere: fence.side === "outside" && fence.beginsThere,
      },
    }),
  };
}
