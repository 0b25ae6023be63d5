// What a state looks like: its size, from what is written in it.
import { widthOf } from "../drawing/text_width.ts";
import type { State } from "../session/protocol.ts";

export const kStateHeight = 64;

// As in styles/states.css [px].
const kNameSize = 14;
const kFarNameSize = 24;
const kFarMargin = 24; // and border, left and right

export function stateSize(state: State): { width: number; height: number } {
  const wanted = Math.max(
    widthOf(state.name, kNameSize, true) + 56,
    Math.min(220, widthOf(state.title || state.member, 11)) + 48,
    128,
  );
  return { width: Math.ceil(Math.min(wanted, 268) / 8) * 8, height: kStateHeight };
}

/** Where a name may be broken: `FindTheDoor` before each capital, `find_door` behind each line. */
export function nameParts(name: string): string[] {
  return name.split(/(?<=[a-z0-9])(?=[A-Z])|(?<=_)(?!_)/);
}

/** The largest letters in which no part of the name is wider than the state, seen from far away [px]. */
export function farNameSize({ name, width }: { name: string; width: number }): number {
  const widest = Math.max(...nameParts(name).map((part) => widthOf(part, kNameSize, true)));
  const fitting = (kNameSize * (width - kFarMargin)) / Math.max(widest, 1);
  return Math.max(kNameSize, Math.min(kFarNameSize, Math.floor(fitting)));
}
