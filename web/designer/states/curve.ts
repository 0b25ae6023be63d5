// The way of a transition: from the rim of one state to the rim of another, bent so that those there and back, and
// several between the same two, do not lie on each other.

export interface Rect {
  x: number;
  y: number;
  width: number;
  height: number;
}
export interface Point {
  x: number;
  y: number;
}
export interface Curve {
  path: string;
  /** Where its label stands. */
  middle: Point;
  begin: Point;
  end: Point;
}

const kBend = 36; // how far the first one of several is out [px]

/** `place` among `count` transitions between these two states, both directions taken together; `isBack`: b is the first of them. */
export function curveBetween(from: Rect, to: Rect, place: number, count: number, isBack: boolean): Curve {
  const a = centreOf(from);
  const b = centreOf(to);
  const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  // The same side for both directions: else two that go there and back would be bent to the same side.
  const sign = isBack ? -1 : 1;
  const across = { x: (-(b.y - a.y) / length) * sign, y: ((b.x - a.x) / length) * sign };
  const out = count === 1 ? 0 : (place - (count - 1) / 2) * 2 * kBend;
  const control = { x: (a.x + b.x) / 2 + across.x * out * 2, y: (a.y + b.y) / 2 + across.y * out * 2 };
  const begin = onRim(from, control);
  const end = onRim(to, control);
  const middle = { x: (begin.x + 2 * control.x + end.x) / 4, y: (begin.y + 2 * control.y + end.y) / 4 };
  return {
    path: `M${round(begin.x)} ${round(begin.y)}Q${round(control.x)} ${round(control.y)} ${round(end.x)} ${round(end.y)}`,
    middle,
    begin,
    end,
  };
}

/** A loop above the state. */
export function loopAt(at: Rect, place: number): Curve {
  const reach = 46 + place * 30;
  const begin = { x: at.x + at.width * 0.62, y: at.y };
  const end = { x: at.x + at.width * 0.38, y: at.y };
  const path = `M${round(begin.x)} ${round(begin.y)}C${round(begin.x + 30)} ${round(at.y - reach)} ${round(end.x - 30)} ${round(at.y - reach)} ${round(end.x)} ${round(end.y)}`;
  return { path, middle: { x: at.x + at.width / 2, y: at.y - reach * 0.75 }, begin, end };
}

export function centreOf(rect: Rect): Point {
  return { x: rect.x + rect.width / 2, y: rect.y + rect.height / 2 };
}

/** Where the way from the centre towards a point leaves the rectangle. */
export function onRim(rect: Rect, towards: Point): Point {
  const centre = centreOf(rect);
  const dx = towards.x - centre.x;
  const dy = towards.y - centre.y;
  if (dx === 0 && dy === 0) return { x: centre.x, y: rect.y };
  const share = Math.min(
    dx === 0 ? Number.POSITIVE_INFINITY : rect.width / 2 / Math.abs(dx),
    dy === 0 ? Number.POSITIVE_INFINITY : rect.height / 2 / Math.abs(dy),
  );
  return { x: centre.x + dx * share, y: centre.y + dy * share };
}

/** For each transition its place among those between the same two states. */
export function lanesOf(
  transitions: readonly { from: string; to: string }[],
): { place: number; count: number; isBack: boolean }[] {
  const pairs = new Map<string, number[]>();
  const keyOf = ({ from, to }: { from: string; to: string }) => (from < to ? `${from} ${to}` : `${to} ${from}`);
  transitions.forEach((one, i) => {
    const key = keyOf(one);
    pairs.set(key, [...(pairs.get(key) ?? []), i]);
  });
  return transitions.map((one, i) => {
    const group = pairs.get(keyOf(one))!;
    return { place: group.indexOf(i), count: group.length, isBack: one.from > one.to };
  });
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
