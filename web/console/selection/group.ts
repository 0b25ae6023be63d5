// Several robots in numbers.
import type { Model } from "../../core/model.ts";
import { shownState } from "../robots/robot_state.ts";

export interface GroupNumbers {
  /** Words of states with how many robots are in each, the most first. */
  states: { word: string; tone: string; robots: number[] }[];
  centre: { x: number; y: number } | undefined;
  /** Greatest distance of a robot from the centre [m]. */
  spread: number;
  /** Of those whose details are there. */
  meanSpeed: number;
  farthest: number; // to the goal [m]; negative: unknown
  lastArrival: number; // run time; negative: unknown
  meanStationError: number; // negative: none has a station
}

export function groupNumbers(
  model: Pick<Model, "robots" | "get" | "placeOf" | "detail">,
  ids: readonly number[],
): GroupNumbers {
  const states = new Map<string, { word: string; tone: string; robots: number[] }>();
  const places: { x: number; y: number }[] = [];
  const speeds: number[] = [];
  const errors: number[] = [];
  let farthest = -1;
  let lastArrival = -1;
  for (const id of ids) {
    const { word, tone } = shownState(model, id);
    const known = states.get(word) ?? { word, tone, robots: [] };
    known.robots.push(id);
    states.set(word, known);
    const place = model.placeOf(id);
    if (place) places.push(place);
    const detail = model.detail(id);
    if (!detail) continue;
    speeds.push(detail.speed);
    if (detail.station) errors.push(detail.stationError);
    farthest = Math.max(farthest, detail.remaining);
    lastArrival = Math.max(lastArrival, detail.arrival);
  }
  const centre = places.length > 0 ? { x: mean(places.map((p) => p.x)), y: mean(places.map((p) => p.y)) } : undefined;
  return {
    states: [...states.values()].sort((a, b) => b.robots.length - a.robots.length),
    centre,
    spread: centre ? Math.max(...places.map((p) => Math.hypot(p.x - centre.x, p.y - centre.y))) : 0,
    meanSpeed: speeds.length > 0 ? mean(speeds) : Number.NaN,
    farthest,
    lastArrival,
    meanStationError: errors.length > 0 ? mean(errors) : -1,
  };
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
