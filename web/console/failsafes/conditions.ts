// What a person asks of the table: conditions as they are typed, and as the server takes them.
import type { MessageInitShape } from "@bufbuild/protobuf";
import {
  type FailsafeStandings,
  type Failsafes_Row,
  FailsafeStandings_State as State,
  type TryFailsafesSchema,
} from "../../core/protocol.ts";
import { readNumber } from "../../ui/words/read_number.ts";

export type Order = MessageInitShape<typeof TryFailsafesSchema>;

/** Conditions with a length, by the words of the table. */
export type Lasting = "LINK-LOST" | "IN-CONTACT" | "STUCK";
export const kLasting: readonly (readonly [Lasting, string])[] = [
  ["LINK-LOST", "Link lost"],
  ["IN-CONTACT", "In contact"],
  ["STUCK", "Stuck"],
];

export interface Conditions<Amount = number> {
  /** How long [s]; nothing: it isn't so. */
  lasting: Partial<Record<Lasting, Amount>>;
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

/** As the server takes them. */
export const kBounds = {
  seconds: { min: 0, max: 600 },
  speed: { min: 0, max: 50 },
  distance: { min: 0, max: 1000 },
  bearing: { min: -360, max: 360 },
} satisfies Record<string, Bounds>;

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
export function firstDraft(own: readonly OwnRow[]): Draft {
  const none: Draft = { lasting: {}, fence: null, speed: "1" };
  const [first] = own;
  if (!first) return none;
  if (first.row.fence !== "") return { ...none, fence: firstFence(own) };
  return { ...none, lasting: { [first.row.condition]: firstSeconds(own, first.row.condition) } };
}

export function firstFence(own: readonly OwnRow[]): AtFence<string> | null {
  const first = own.find(({ row }) => row.fence !== "");
  return first ? { row: first.index, side: "inside", distance: "5", bearing: "0", beginsThere: false } : null;
}

/** A second more than the longest row of this condition takes. */
export function firstSeconds(own: readonly OwnRow[], condition: string): string {
  const longest = Math.max(0, ...own.filter(({ row }) => row.condition === condition).map(({ row }) => row.seconds));
  return String(Math.min(kBounds.seconds.max, Math.ceil(longest) + 1));
}

/** What can be asked of these rows. */
export function askable(own: readonly OwnRow[]): readonly (readonly [Lasting, string])[] {
  return kLasting.filter(([condition]) => own.some(({ row }) => row.condition === condition));
}

export function fences(own: readonly OwnRow[]): readonly (readonly [string, string])[] {
  return own.flatMap(({ index, row }) =>
    row.fence === "" ? [] : [[String(index), `${index + 1}. ${row.fence}`] as const],
  );
}

/** Of what was asked of another robot, what can be asked of this one. */
export function fitted(draft: Draft, own: readonly OwnRow[]): Draft {
  const lasting: Draft["lasting"] = {};
  for (const [condition] of askable(own)) {
    const seconds = draft.lasting[condition];
    if (seconds !== undefined) lasting[condition] = seconds;
  }
  const first = firstFence(own);
  const isOwn = own.some(({ index, row }) => index === draft.fence?.row && row.fence !== "");
  const fence = draft.fence && first && (isOwn ? draft.fence : { ...draft.fence, row: first.row });
  return { ...draft, lasting, fence };
}

/** The names of those numbers that are none, or out of bounds. */
export function wrongIn(draft: Draft): readonly string[] {
  return amounts(draft).flatMap(([name, text, { min, max }]) =>
    readNumber(text, min, max).problem === undefined ? [] : [name],
  );
}

function amounts({ lasting, fence, speed }: Draft): readonly (readonly [string, string, Bounds])[] {
  return [
    ...kLasting.flatMap(([condition, label]) => {
      const text = lasting[condition];
      return text === undefined ? [] : [[label, text, kBounds.seconds] as const];
    }),
    ...(fence
      ? [["Distance", fence.distance, kBounds.distance] as const, ["Heading", fence.bearing, kBounds.bearing] as const]
      : []),
    ["Speed", speed, kBounds.speed],
  ];
}

/** What is tried with the robot; nothing while a number is wrong. */
export function orderOf(robot: number, draft: Draft): Order | undefined {
  if (wrongIn(draft).length > 0) return undefined;
  const { lasting, fence, speed } = draft;
  const amount = (text = "0") => readNumber(text).number;
  return {
    robot,
    linkLost: amount(lasting["LINK-LOST"]),
    inContact: amount(lasting["IN-CONTACT"]),
    stuck: amount(lasting.STUCK),
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
