// Rectangles and the lines that pass them.
import type { Curve, Point, Rect } from "./curve.ts";

const kPieces = 20;

/** A curve as a row of points, near enough. */
export function pathOf(curve: Curve): Point[] {
  return Array.from({ length: kPieces + 1 }, (_, i) => curve.pointAt(i / kPieces));
}

export function enlargedRect(rect: Rect, by: number): Rect {
  return { x: rect.x - by, y: rect.y - by, width: rect.width + 2 * by, height: rect.height + 2 * by };
}

export function contains(rect: Rect, at: Point): boolean {
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

/** Called for millions of pieces while a page is drawn, so it makes nothing. */
function passes(a: Point, b: Point, { x, y, width, height }: Rect): boolean {
  if ((a.x <= x && b.x <= x) || (a.x >= x + width && b.x >= x + width)) return false;
  if ((a.y <= y && b.y <= y) || (a.y >= y + height && b.y >= y + height)) return false;
  // between which shares of the way from `a` to `b` it is within the limits, across and down
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  let begin = 0;
  let end = 1;
  if (dx !== 0) {
    const left = (x - a.x) / dx;
    const right = (x + width - a.x) / dx;
    begin = Math.max(begin, Math.min(left, right));
    end = Math.min(end, Math.max(left, right));
  }
  if (dy !== 0) {
    const top = (y - a.y) / dy;
    const bottom = (y + height - a.y) / dy;
    begin = Math.max(begin, Math.min(top, bottom));
    end = Math.min(end, Math.max(top, bottom));
  }
  return begin < end;
}
