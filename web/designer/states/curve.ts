// The way of a transition: from the rim of one state to the rim of another, bent aside as far as it has to be.

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
  begin: Point;
  end: Point;
  /** 0: where it begins, 1: where it ends. */
  pointAt(share: number): Point;
}

/** `bend`: how far its middle is aside [px], to the left of the way; `isBack`: of the way back, so that both agree on the side. */
export function curveBetween(from: Rect, to: Rect, bend: number, isBack: boolean): Curve {
  const a = centreOf(from);
  const b = centreOf(to);
  const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  const sign = isBack ? -1 : 1;
  const across = { x: (-(b.y - a.y) / length) * sign, y: ((b.x - a.x) / length) * sign };
  const control = { x: (a.x + b.x) / 2 + across.x * bend * 2, y: (a.y + b.y) / 2 + across.y * bend * 2 };
  const begin = onRim(from, control);
  const end = onRim(to, control);
  const path = `M${round(begin.x)} ${round(begin.y)}Q${round(control.x)} ${round(control.y)} ${round(end.x)} ${round(end.y)}`;
  return { path, begin, end, pointAt: (share) => between([begin, control, end], share) };
}

/** A loop: above the state, the farther the larger `place` is; below it where that is negative. */
export function loopAt(at: Rect, place: number): Curve {
  const isBelow = place < 0;
  const reach = 48 + (isBelow ? -place - 1 : place) * 36;
  const rim = isBelow ? at.y + at.height : at.y;
  const far = isBelow ? rim + reach : rim - reach;
  const begin = { x: at.x + at.width * 0.64, y: rim };
  const end = { x: at.x + at.width * 0.36, y: rim };
  const [out, back] = [
    { x: begin.x + 30, y: far },
    { x: end.x - 30, y: far },
  ];
  const path = `M${round(begin.x)} ${round(begin.y)}C${round(out.x)} ${round(out.y)} ${round(back.x)} ${round(back.y)} ${round(end.x)} ${round(end.y)}`;
  return { path, begin, end, pointAt: (share) => between([begin, out, back, end], share) };
}

/** On the curve that these points pull (de Casteljau). */
function between(points: readonly Point[], share: number): Point {
  if (points.length === 1) return points[0]!;
  return between(
    points.slice(1).map((next, i) => {
      const last = points[i]!;
      return { x: last.x + (next.x - last.x) * share, y: last.y + (next.y - last.y) * share };
    }),
    share,
  );
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

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
