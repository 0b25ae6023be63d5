// Control measures as goals of commands: what a click means, and how MDL refers to it.

import { centreOf, distanceToSegment, type Point } from "../../core/geometry.ts";
import { type MdlPlace, mdlName, mdlNumber } from "../../core/mdl_text.ts";
import { keywordOf, kLineKinds, type MeasureKind } from "../../core/measure_kinds.ts";

/** What is needed of a Measure. */
export interface PlaceMeasure {
  readonly kind: MeasureKind;
  readonly name: string;
  readonly points: readonly Point[];
  readonly size: number;
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
  at: Point,
  origin: Point,
  decimals: number,
): MdlPlace {
  const reference = snapped === null ? null : referenceTo(measures, snapped);
  if (reference !== null) return { reference };
  const point = snapped === null ? at : centreOf(measures[snapped]?.points ?? [at]);
  return {
    x: Number(mdlNumber(point.x - origin.x, decimals)),
    y: Number(mdlNumber(point.y - origin.y, decimals)),
  };
}

/** The measure whose centre is nearest to the point and at most `reach` away; null if there is none. */
export function snapToCenter(measures: readonly PlaceMeasure[], at: Point, reach: number): number | null {
  let best: number | null = null;
  let least = reach;
  measures.forEach((m, i) => {
    if (m.points.length === 0 || m.kind === "wall") return;
    const c = centreOf(m.points);
    const d = Math.hypot(c.x - at.x, c.y - at.y);
    if (d > least) return;
    least = d;
    best = i;
  });
  return best;
}

/** The line that comes nearest to the point and at most `reach` away, walls included; null if there is none. */
export function nearestLine(measures: readonly PlaceMeasure[], at: Point, reach: number): number | null {
  let best: number | null = null;
  let least = reach;
  measures.forEach((m, i) => {
    if (!kLineKinds.has(m.kind)) return;
    for (let k = 0; k + 1 < m.points.length; ++k) {
      const d = distanceToSegment(at, m.points[k] as Point, m.points[k + 1] as Point);
      if (d > least) continue;
      least = d;
      best = i;
    }
  });
  return best;
}
