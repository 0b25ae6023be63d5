// The way of a wire: leaves to the right, arrives from the left.

export interface Point {
  x: number;
  y: number;
}

export function wirePath(from: Point, to: Point): { path: string; middle: Point } {
  const forward = to.x - from.x;
  const reach = forward >= 0 ? Math.max(24, forward * 0.45) : Math.min(220, 60 + Math.abs(forward) * 0.4);
  const a = { x: from.x + reach, y: from.y };
  const b = { x: to.x - reach, y: to.y };
  return {
    path: `M${round(from.x)} ${round(from.y)}C${round(a.x)} ${round(a.y)} ${round(b.x)} ${round(b.y)} ${round(to.x)} ${round(to.y)}`,
    middle: { x: (from.x + 3 * a.x + 3 * b.x + to.x) / 8, y: (from.y + 3 * a.y + 3 * b.y + to.y) / 8 },
  };
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
