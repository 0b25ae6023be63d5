// Changing the points of a measure that stands: handles to drag, points put in between and taken out.

import type { Point } from "../../core/geometry.ts";
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";

/** A place to take hold of. Corners are points; middles become one when they are dragged; the whole moves everything. */
export type Handle =
  | { readonly type: "corner"; readonly index: number }
  | { readonly type: "middle"; readonly after: number }
  | { readonly type: "radius" }
  | { readonly type: "whole" };

export interface PlacedHandle {
  readonly handle: Handle;
  readonly x: number;
  readonly y: number;
}

/** Whether the last point is joined to the first. */
export function isClosed(kind: MeasureKind, count: number): boolean {
  const shape = kindInfo(kind).shape;
  return count >= 3 && (shape === "region" || shape === "hallway");
}

/** Where one can take hold of a measure. A single point with a diameter has a handle at the east of its circle. */
export function handlesOf(kind: MeasureKind, points: readonly Point[], size: number): PlacedHandle[] {
  const info = kindInfo(kind);
  const handles: PlacedHandle[] = points.map((p, index) => ({ handle: { type: "corner", index }, x: p.x, y: p.y }));
  const first = points[0];
  if (points.length === 1 && first && info.sizeLabel === "diameter") {
    const radius = (size > 0 ? size : info.defaultSize) / 2;
    handles.push({ handle: { type: "radius" }, x: first.x + radius, y: first.y });
  }
  if (points.length >= 2 && points.length < info.maxPoints) {
    const last = isClosed(kind, points.length) ? points.length : points.length - 1;
    for (let after = 0; after < last; ++after) {
      const a = points[after] as Point;
      const b = points[(after + 1) % points.length] as Point;
      handles.push({ handle: { type: "middle", after }, x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
    }
  }
  return handles;
}

export interface Geometry {
  readonly points: readonly Point[];
  readonly size: number;
}

/** What a handle makes of a measure when it is dragged from one place to another. Middles put a point in. */
export function dragHandle(before: Geometry, handle: Handle, from: Point, to: Point): Geometry {
  switch (handle.type) {
    case "corner":
      return { ...before, points: before.points.map((p, i) => (i === handle.index ? to : p)) };
    case "middle":
      return {
        ...before,
        points: [...before.points.slice(0, handle.after + 1), to, ...before.points.slice(handle.after + 1)],
      };
    case "radius": {
      const center = before.points[0] ?? to;
      return { ...before, size: 2 * Math.hypot(to.x - center.x, to.y - center.y) };
    }
    case "whole":
      return moveAll(before, to.x - from.x, to.y - from.y);
  }
}

export function moveAll(before: Geometry, dx: number, dy: number): Geometry {
  return { ...before, points: before.points.map((p) => ({ x: p.x + dx, y: p.y + dy })) };
}

/** Without one point; null where the kind needs all that there are. */
export function removeCorner(kind: MeasureKind, before: Geometry, index: number): Geometry | null {
  const info = kindInfo(kind);
  if (index < 0 || index >= before.points.length) return null;
  const points = before.points.filter((_, i) => i !== index);
  const isBrokenRegion = info.shape === "region" && points.length === 2;
  if (points.length < info.minPoints || isBrokenRegion) return null;
  return { ...before, points };
}
