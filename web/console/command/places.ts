// Control measures as goals of commands: what a click means, and how MDL refers to it.

import { keywordOf, kLineKinds, type MeasureKind } from "../overlay/kinds.ts";
import { type MdlPlace, mdlName, mdlNumber } from "./mdl_text.ts";

interface XY {
  readonly x: number;
  readonly y: number;
}

/** What is needed of a Measure. */
export interface PlaceMeasure {
  readonly kind: MeasureKind;
  readonly name: string;
  readonly points: readonly XY[];
  readonly size: number;
}

/** The middle of a feature, where a unit goes that is sent there: the mean of its points. */
export function centerOf(points: readonly XY[]): XY {
  const n = Math.max(points.length, 1);
  let x = 0;
  let y = 0;
  for (const p of points) {
    x += p.x;
    y += p.y;
  }
  return { x: x / n, y: y / n };
}

/**
 * How a mission refers to measure `index`: `PP-Charlie` where that finds it, else its bare name. null where no name finds
 * it, because it has none or a later one has the same.
 */
export function referenceTo(measures: readonly PlaceMeasure[], index: number): string | null {
  const measure = measures[index];
  if (!measure || mdlName(measure.name) === null) return null;
  const name = measure.name;
  const last = measures.findLastIndex((m) => m.name === name);
  if (last !== index) return null;
  const keyword = keywordOf(measure.kind);
  const hasPrefix = name.toUpperCase().startsWith(`${keyword}-`);
  const isWord = mdlName(name) === name;
  const prefixed = `${keyword}-${name}`;
  if (hasPrefix || !isWord || measures.some((m) => m.name === prefixed)) return name;
  return prefixed;
}

/** The place of a command: the measure where there is one with a name, else the point, rounded. */
export function placeFor(
  measures: readonly PlaceMeasure[],
  snapped: number | null,
  at: XY,
  origin: XY,
  decimals: number,
): MdlPlace {
  const reference = snapped === null ? null : referenceTo(measures, snapped);
  if (reference !== null) return { reference };
  const point = snapped === null ? at : centerOf(measures[snapped]?.points ?? [at]);
  return {
    x: Number(mdlNumber(point.x - origin.x, decimals)),
    y: Number(mdlNumber(point.y - origin.y, decimals)),
  };
}

/** The measure whose centre is nearest to the point and at most `reach` away; null if there is none. */
export function snapToCenter(measures: readonly PlaceMeasure[], at: XY, reach: number): number | null {
  let best: number | null = null;
  let least = reach;
  measures.forEach((m, i) => {
    if (m.points.length === 0 || m.kind === "wall") return;
    const c = centerOf(m.points);
    const d = Math.hypot(c.x - at.x, c.y - at.y);
    if (d > least) return;
    least = d;
    best = i;
  });
  return best;
}

/** The line that comes nearest to the point and at most `reach` away, walls included; null if there is none. */
export function nearestLine(measures: readonly PlaceMeasure[], at: XY, reach: number): number | null {
  let best: number | null = null;
  let least = reach;
  measures.forEach((m, i) => {
    if (!kLineKinds.has(m.kind)) return;
    for (let k = 0; k + 1 < m.points.length; ++k) {
      const d = distanceToSegment(at, m.points[k] as XY, m.points[k + 1] as XY);
      if (d > least) continue;
      least = d;
      best = i;
    }
  });
  return best;
}

export function distanceToSegment(p: XY, a: XY, b: XY): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / square)) : 0;
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}
