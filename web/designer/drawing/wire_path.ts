// The way of a wire: leaves to the right, arrives from the left.

export interface Point {
  x: number;
  y: number;
}

/** `reach` is what it takes from left to right: one that leads back goes round both its ends. */
export function wirePath(
  from: Point,
  to: Point,
): { path: string; middle: Point; reach: { x: number; y: number; width: number } } {
  const forward = to.x - from.x;
  const reach = forward >= 0 ? Math.max(24, forward * 0.45) : Math.min(220, 60 + Math.abs(forward) * 0.4);
  const a = { x: from.x + reach, y: from.y };
  const b = { x: to.x - reach, y: to.y };
  // No further than its control points, of which it comes three quarters of the way at most.
  const [left, right] = forward >= 0 ? [from.x, to.x] : [to.x - reach * 0.75, from.x + reach * 0.75];
  return {
    path: `M${round(from.x)} ${round(from.y)}C${round(a.x)} ${round(a.y)} ${round(b.x)} ${round(b.y)} ${round(to.x)} ${round(to.y)}`,
    middle: { x: (from.x + 3 * a.x + 3 * b.x + to.x) / 8, y: (from.y + 3 * a.y + 3 * b.y + to.y) / 8 },
    reach: { x: left, y: from.y, width: right - left },
  };
}

/** Half of what a value may take beside a wire, and the room that it keeps to the nodes [px]. */
const kHalfBadge = 44;
const kAbove = 30;

/**
 * Where the value stands that flows in a wire: in its middle where there is room between the nodes, else above the corner
 * of the node that it comes from.
 */
export function badgePlace(from: Point, to: Point): { at: Point; isAbove: boolean } {
  if (to.x - from.x >= 2 * kHalfBadge) return { at: wirePath(from, to).middle, isAbove: false };
  return { at: { x: from.x + 8, y: from.y - kAbove }, isAbove: true };
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
