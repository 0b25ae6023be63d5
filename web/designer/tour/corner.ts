// Where the card of the tour stands: in the corner of the canvas where it lies on the least of what is drawn.
import type { Rect } from "../states/curve.ts";

export const kCorners = ["bottom-right", "top-right", "bottom-left", "top-left"] as const;
export type Corner = (typeof kCorners)[number];

const kGap = 16; // px from the edges
const kTools = 64; // px at the left, where the tools of the canvas are

/** The one that it has stays while it is as good as any. */
export function bestCorner(
  area: Rect,
  card: { width: number; height: number },
  drawn: readonly Rect[],
  now: Corner,
): Corner {
  const covered = (corner: Corner) => drawn.reduce((sum, one) => sum + overlap(cardAt(area, card, corner), one), 0);
  let best = now;
  for (const corner of kCorners) if (covered(corner) < covered(best)) best = corner;
  return best;
}

export function cardAt(area: Rect, { width, height }: { width: number; height: number }, corner: Corner): Rect {
  const x = corner.endsWith("left") ? area.x + kTools : area.x + area.width - width - kGap;
  const y = corner.startsWith("top") ? area.y + kGap : area.y + area.height - height - kGap;
  return { x, y, width, height };
}

/** [px²] */
export function overlap(a: Rect, b: Rect): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

export function isInside(inner: Rect, outer: Rect): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}
