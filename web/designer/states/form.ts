// What a state looks like: its size, from what is written in it.
import { widthOf } from "../canvas/text_width.ts";
import type { State } from "../protocol.ts";

export const kStateHeight = 64;

export function stateSize(state: State): { width: number; height: number } {
  const wanted = Math.max(
    widthOf(state.name, 14, true) + 56,
    Math.min(220, widthOf(state.title || state.member, 11)) + 48,
    128,
  );
  return { width: Math.ceil(Math.min(wanted, 268) / 8) * 8, height: kStateHeight };
}
