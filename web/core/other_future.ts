// The other future of a run at any of its moments, and its distance from the run.
import type { Log_Entry, OtherFuture, OtherFuture_Robot } from "./protocol.ts";

export interface Ghost {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly heading: number;
}

/** The last sample at or before a time; -1: none. */
export function sampleBefore(times: readonly number[], time: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time + 1e-4) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Where a robot is then, between samples on the straight line; after the last one where it was. */
export function ghostAt(future: OtherFuture, robot: OtherFuture_Robot, time: number): Ghost | undefined {
  const at = sampleBefore(future.times, time);
  if (at < 0) return undefined;
  const next = Math.min(at + 1, future.times.length - 1);
  const [from, to] = [future.times[at]!, future.times[next]!];
  const x = robot.x[at] ?? Number.NaN;
  const y = robot.y[at] ?? Number.NaN;
  const heading = robot.heading[at] ?? Number.NaN;
  if (!Number.isFinite(x) || !Number.isFinite(y)) return undefined;
  const hasNext = next > at && Number.isFinite(robot.x[next]);
  const share = hasNext ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 0;
  const turn = hasNext
    ? Math.atan2(Math.sin(robot.heading[next]! - heading), Math.cos(robot.heading[next]! - heading))
    : 0;
  return {
    id: robot.robot,
    x: hasNext ? x + share * (robot.x[next]! - x) : x,
    y: hasNext ? y + share * (robot.y[next]! - y) : y,
    heading: heading + share * turn,
  };
}

/** It is shown: computed, and without a problem. */
export function isShown(future: OtherFuture | null): future is OtherFuture {
  return future !== null && !future.isUnderWay && future.problem === "" && future.times.length > 0;
}

export type FutureSide = "own" | "other";

/** Where it is, when it is in one of both only. */
export function isAlone({ own, other }: OtherFuture_Robot): FutureSide | undefined {
  if ((own?.isThere === true) === (other?.isThere === true)) return undefined;
  return own?.isThere ? "own" : "other";
}

/** The robots that only one of both has, by number. */
export function aloneIn(future: OtherFuture, side: FutureSide): number[] {
  const alone = future.robots.filter((robot) => isAlone(robot) === side);
  return alone.map(({ robot }) => robot).sort((a, b) => a - b);
}

export interface Told {
  readonly side: FutureSide;
  readonly entry: Log_Entry;
}

/** What was told in one of both alone, by time. */
export function toldApart(future: OtherFuture): Told[] {
  const of = (side: FutureSide, entries: readonly Log_Entry[]) => entries.map((entry) => ({ side, entry }));
  return [...of("own", future.toldOwn), ...of("other", future.toldOther)].sort((a, b) => a.entry.time - b.entry.time);
}

/** The robots whose ways part most come first. */
export function byDistance(future: OtherFuture): OtherFuture_Robot[] {
  return [...future.robots].sort((a, b) => b.mostApart - a.mostApart || a.robot - b.robot);
}
