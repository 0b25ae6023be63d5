// How far and in which direction the objective lies.

import type { Point } from "../../core/geometry.ts";

export interface Objective {
  /** [m] */
  readonly distance: number;
  /** Degrees clockwise from north, 0 to 359, as on a compass. */
  readonly bearing: number;
  readonly wind: string;
  /** Where the needle points: radians clockwise from straight up of the pad. */
  readonly needle: number;
}

const kWinds = ["N", "NE", "E", "SE", "S", "SW", "W", "NW"] as const;

/** `heading` of the robots [rad, counter-clockwise from east]: the needle is relative to it in the robot's frame. */
export function objectiveFrom(from: Point, to: Point, heading: number, robotFrame: boolean): Objective {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const clockwise = Math.atan2(dx, dy);
  const degrees = ((((clockwise * 180) / Math.PI) % 360) + 360) % 360;
  const ahead = Math.PI / 2 - heading;
  return {
    distance: Math.hypot(dx, dy),
    bearing: Math.round(degrees) % 360,
    wind: kWinds[Math.round(degrees / 45) % 8] as string,
    needle: wrap(robotFrame ? clockwise - ahead : clockwise),
  };
}

/** The middle of points, and the mean of their directions; null of none. */
export function meanPose(
  poses: readonly { x: number; y: number; heading: number }[],
): { x: number; y: number; heading: number } | null {
  if (poses.length === 0) return null;
  let x = 0;
  let y = 0;
  let c = 0;
  let s = 0;
  for (const p of poses) {
    x += p.x;
    y += p.y;
    c += Math.cos(p.heading);
    s += Math.sin(p.heading);
  }
  return { x: x / poses.length, y: y / poses.length, heading: Math.atan2(s, c) };
}

/** `042°`, as compasses are read. */
export function bearingText(degrees: number): string {
  return `${String(degrees).padStart(3, "0")}°`;
}

export function distanceText(metres: number): string {
  if (metres >= 10_000) return `${(metres / 1000).toFixed(1)} km`;
  return metres >= 100 ? `${Math.round(metres)} m` : `${metres.toFixed(1)} m`;
}

function wrap(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}
