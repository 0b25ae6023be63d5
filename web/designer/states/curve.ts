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
  /** Where its label stands. */
  middle: Point;
  begin: Point;
  control: Point;
  end: Point;
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
  const middle = { x: (begin.x + 2 * control.x + end.x) / 4, y: (begin.y + 2 * control.y + end.y) / 4 };
  const path = `M${round(begin.x)} ${round(begin.y)}Q${round(control.x)} ${round(control.y)} ${round(end.x)} ${round(end.y)}`;
  return { path, middle, begin, control, end };
}

/** A loop above the state. */
export function loopAt(at: Rect, place: number): Curve {
  const reach = 46 + place * 30;
  const begin = { x: at.x + at.width * 0.62, y: at.y };
  const end = { x: at.x + at.width * 0.38, y: at.y };
  const control = { x: at.x + at.width / 2, y: at.y - reach };
  const path = `M${round(begin.x)} ${round(begin.y)}C${round(begin.x + 30)} ${round(control.y)} ${round(end.x - 30)} ${round(control.y)} ${round(end.x)} ${round(end.y)}`;
  return { path, middle: { x: control.x, y: at.y - reach * 0.75 }, begin, control, end };
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
