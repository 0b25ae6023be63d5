// Rectangles and the lines that pass them.
import type { Curve, Point, Rect } from "./curve.ts";

const kPieces = 20;

/** A curve as a row of points, near enough. */
export function pathOf(curve: Curve): Point[] {
  return Array.from({ length: kPieces + 1 }, (_, i) => curve.pointAt(i / kPieces));
}

export function enlarged(rect: Rect, by: number): Rect {
  return { x: rect.x - by, y: rect.y - by, width: rect.width + 2 * by, height: rect.height + 2 * by };
}

export function holds(rect: Rect, at: Point): boolean {
  return at.x > rect.x && at.x < rect.x + rect.width && at.y > rect.y && at.y < rect.y + rect.height;
}

/** Whether they are nearer to each other than `gap`. */
export function isOver(a: Rect, b: Rect, gap = 0): boolean {
  return (
    a.x < b.x + b.width + gap && b.x < a.x + a.width + gap && a.y < b.y + b.height + gap && b.y < a.y + a.height + gap
  );
}

/** Whether any piece of the line passes through the rectangle. */
export function crosses(points: readonly Point[], rect: Rect): boolean {
  for (let i = 1; i < points.length; ++i) if (passes(points[i - 1]!, points[i]!, rect)) return true;
  return false;
}

function passes(a: Point, b: Point, rect: Rect): boolean {
  const across = clipped(a.x, b.x, rect.x, rect.x + rect.width);
  const down = clipped(a.y, b.y, rect.y, rect.y + rect.height);
  return across !== null && down !== null && Math.max(across[0], down[0], 0) < Math.min(across[1], down[1], 1);
}

/** Between which shares of the way from `a` to `b` it is within the limits. */
function clipped(a: number, b: number, low: number, high: number): [number, number] | null {
  if (a === b) return a > low && a < high ? [0, 1] : null;
  const [begin, end] = [(low - a) / (b - a), (high - a) / (b - a)];
  return begin < end ? [begin, end] : [end, begin];
}
