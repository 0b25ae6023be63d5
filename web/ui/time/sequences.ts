// The states of a robot's sequences over the whole run: as pieces that can be drawn, and as rows that can be read.
import type { Past_Sequence } from "../../core/protocol.ts";
import type { Span } from "./span.ts";

export interface Piece {
  readonly begin: number;
  readonly end: number;
  readonly state: string;
}

export interface SequenceTrack {
  readonly path: string;
  /** In the order of their first appearance. */
  readonly states: readonly string[];
  /** Ordered, without those in which it does not run. */
  readonly pieces: readonly Piece[];
}

/** `knownTo`: until then the last piece of each lasts. */
export function tracksOf(sequences: readonly Past_Sequence[], knownTo: number): SequenceTrack[] {
  return sequences.map(({ path, spans }) => {
    const pieces: Piece[] = [];
    const states = new Set<string>();
    spans.forEach(({ begin, state }, i) => {
      const end = Math.max(begin, spans[i + 1]?.begin ?? knownTo);
      if (state === "" || end <= begin) return;
      states.add(state);
      pieces.push({ begin, end, state });
    });
    return { path, states: [...states], pieces };
  });
}

export function pieceAt({ pieces }: SequenceTrack, time: number): Piece | undefined {
  return pieces.findLast((one) => one.begin <= time && time < one.end) ?? pieces.find((one) => one.end === time);
}

/** A run of one state, or of so many changes that they can't be told apart. */
export interface Strip {
  /** Pixels from the left. */
  readonly left: number;
  readonly right: number;
  /** Index into SequenceTrack.states; -1: several. */
  readonly state: number;
}

/** What is drawn over `width` pixels: pieces narrower than a pixel are drawn together, so that there are never many more than pixels. */
export function stripsIn(track: SequenceTrack, span: Span, width: number): Strip[] {
  const x = (time: number) => ((time - span.from) / (span.to - span.from)) * width;
  const index = new Map(track.states.map((state, i) => [state, i]));
  const strips: Strip[] = [];
  for (const { begin, end, state } of track.pieces) {
    if (end < span.from || begin > span.to) continue;
    const left = Math.max(0, x(begin));
    const right = Math.min(width, x(end));
    const last = strips.at(-1);
    const one = { left, right, state: index.get(state) ?? -1 };
    if (last && right - left < 1 && last.right - last.left < 1.5 && left - last.right < 0.5) {
      strips[strips.length - 1] = { left: last.left, right, state: last.state === one.state ? one.state : -1 };
    } else strips.push(one);
  }
  return strips;
}
