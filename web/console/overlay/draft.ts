// A control measure while it is being drawn: points come one by one, or a drag gives a circle.

import type { Point } from "../../core/geometry.ts";
import { type KindInfo, kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";

export interface Draft {
  readonly kind: MeasureKind;
  readonly points: readonly Point[];
  /** As dragged or typed; 0: the kind's default. */
  readonly size: number;
}

export function emptyDraft(kind: MeasureKind): Draft {
  return { kind, points: [], size: 0 };
}

/** One more point. A point on top of the last one (a double click) adds nothing. */
export function addPoint(draft: Draft, point: Point, tolerance = 0): Draft {
  const info = kindInfo(draft.kind);
  if (draft.points.length >= info.maxPoints) return draft;
  const last = draft.points.at(-1);
  if (last && Math.hypot(last.x - point.x, last.y - point.y) <= tolerance) return draft;
  return { ...draft, points: [...draft.points, point] };
}

export function removeLastPoint(draft: Draft): Draft {
  return { ...draft, points: draft.points.slice(0, -1) };
}

/** A circle by dragging from its middle to its edge; only of what may be one point with a diameter. */
export function circleDraft(kind: MeasureKind, center: Point, edge: Point): Draft {
  const radius = Math.hypot(edge.x - center.x, edge.y - center.y);
  return { kind, points: [center], size: 2 * radius };
}

export function canBeCircle(info: KindInfo): boolean {
  return info.minPoints === 1 && info.sizeLabel === "diameter";
}

/** All points that it can have are there: no Enter is needed. */
export function isFull(draft: Draft): boolean {
  return draft.points.length >= kindInfo(draft.kind).maxPoints;
}

/** What is missing for it to be a measure, as a sentence; empty: nothing. */
export function missingInDraft(draft: Draft): string {
  const info = kindInfo(draft.kind);
  const n = draft.points.length;
  if (n < info.minPoints) {
    const more = info.minPoints - n;
    return more === 1 ? "Needs one more point." : `Needs ${more} more points.`;
  }
  if (info.shape === "region" && n === 2) return "A region needs one point or at least three.";
  return "";
}

/** What the pointer does next, for the person who draws. */
export function guidance(draft: Draft): string {
  const info = kindInfo(draft.kind);
  const n = draft.points.length;
  if (info.shape === "point")
    return canBeCircle(info) ? "Click a place, or drag to set its diameter." : "Click a place.";
  if (info.shape === "hallway") return n === 0 ? "Click one end of the hallway’s centre line." : "Click its other end.";
  if (info.maxPoints === 2) return n === 0 ? "Click its first end." : "Click its second end.";
  if (n === 0 && canBeCircle(info)) return "Drag for a circle, or click the corners one by one.";
  const rest = missingInDraft(draft);
  if (rest !== "") return info.shape === "region" ? "Click the next corner." : "Click the next point.";
  return info.shape === "region"
    ? "Click the next corner; Enter or a double click closes it, Backspace takes one back."
    : "Click the next point; Enter or a double click ends it, Backspace takes one back.";
}

/** A measure's points: those of a hallway are the corners round its centre line. */
export function measurePoints(draft: Draft): { points: Point[]; centerline: Point[] } {
  if (kindInfo(draft.kind).shape !== "hallway") return { points: [...draft.points], centerline: [] };
  return hallwayPoints(draft.points, draft.size > 0 ? draft.size : kindInfo("hallway").defaultSize);
}

/** The rectangle of this width round a centre line's two ends. */
export function hallwayPoints(centerline: readonly Point[], width: number): { points: Point[]; centerline: Point[] } {
  const a = centerline[0];
  const b = centerline.at(-1);
  if (!a || !b) return { points: [], centerline: [...centerline] };
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  const nx = length > 0 ? (-(b.y - a.y) / length) * (width / 2) : 0;
  const ny = length > 0 ? ((b.x - a.x) / length) * (width / 2) : width / 2;
  return {
    centerline: [...centerline],
    points: [
      { x: a.x + nx, y: a.y + ny },
      { x: b.x + nx, y: b.y + ny },
      { x: b.x - nx, y: b.y - ny },
      { x: a.x - nx, y: a.y - ny },
    ],
  };
}
