// Plane geometry in metres or in pixels alike.

export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Box {
  readonly xMin: number;
  readonly yMin: number;
  readonly xMax: number;
  readonly yMax: number;
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(b.x - a.x, b.y - a.y);
}

export function add(a: Point, b: Point, factor = 1): Point {
  return { x: a.x + b.x * factor, y: a.y + b.y * factor };
}

export function pointBetween(a: Point, b: Point, share: number): Point {
  return { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share };
}

/** Length 1; of two equal points the direction of x. */
export function direction(from: Point, to: Point): Point {
  const length = distance(from, to);
  return length > 0 ? { x: (to.x - from.x) / length, y: (to.y - from.y) / length } : { x: 1, y: 0 };
}

/** A quarter turn counter-clockwise where y points up. */
export function perpendicular(of: Point): Point {
  return { x: -of.y, y: of.x };
}

/** The mean of the points, as the mission language takes it; (0, 0) of none. */
export function centreOf(points: readonly Point[]): Point {
  if (points.length === 0) return { x: 0, y: 0 };
  let x = 0;
  let y = 0;
  for (const point of points) {
    x += point.x;
    y += point.y;
  }
  return { x: x / points.length, y: y / points.length };
}

/** null of no points. */
export function boundsOf(points: readonly Point[]): Box | null {
  if (points.length === 0) return null;
  let box: Box = { xMin: Infinity, yMin: Infinity, xMax: -Infinity, yMax: -Infinity };
  for (const { x, y } of points) {
    box = {
      xMin: Math.min(box.xMin, x),
      yMin: Math.min(box.yMin, y),
      xMax: Math.max(box.xMax, x),
      yMax: Math.max(box.yMax, y),
    };
  }
  return box;
}

export function union(a: Box, b: Box): Box {
  return {
    xMin: Math.min(a.xMin, b.xMin),
    yMin: Math.min(a.yMin, b.yMin),
    xMax: Math.max(a.xMax, b.xMax),
    yMax: Math.max(a.yMax, b.yMax),
  };
}

export function grow(box: Box, by: number): Box {
  return { xMin: box.xMin - by, yMin: box.yMin - by, xMax: box.xMax + by, yMax: box.yMax + by };
}

export function overlaps(a: Box, b: Box): boolean {
  return a.xMin < b.xMax && b.xMin < a.xMax && a.yMin < b.yMax && b.yMin < a.yMax;
}

export function contains(box: Box, point: Point): boolean {
  return point.x >= box.xMin && point.x <= box.xMax && point.y >= box.yMin && point.y <= box.yMax;
}

/** The box with two opposite corners. */
export function boxOf(a: Point, b: Point): Box {
  return { xMin: Math.min(a.x, b.x), yMin: Math.min(a.y, b.y), xMax: Math.max(a.x, b.x), yMax: Math.max(a.y, b.y) };
}

export function distanceToSegment(point: Point, a: Point, b: Point): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const square = dx * dx + dy * dy;
  const share = square > 0 ? ((point.x - a.x) * dx + (point.y - a.y) * dy) / square : 0;
  return distance(point, pointBetween(a, b, Math.max(0, Math.min(1, share))));
}

/** Whether any of the segment lies in the box. @source Liang and Barsky 1984 */
export function crosses(box: Box, a: Point, b: Point): boolean {
  let from = 0;
  let to = 1;
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  for (const [step, room] of [
    [-dx, a.x - box.xMin],
    [dx, box.xMax - a.x],
    [-dy, a.y - box.yMin],
    [dy, box.yMax - a.y],
  ] as const) {
    if (step === 0) {
      if (room < 0) return false;
    } else if (step < 0) from = Math.max(from, room / step);
    else to = Math.min(to, room / step);
  }
  return from <= to;
}

/** Infinity of no points. */
export function distanceToLine(point: Point, line: readonly Point[], isClosed = false): number {
  if (line.length === 1) return distance(point, line[0]!);
  let nearest = Infinity;
  for (let i = 1; i < line.length; ++i) {
    nearest = Math.min(nearest, distanceToSegment(point, line[i - 1]!, line[i]!));
  }
  if (isClosed && line.length > 2) nearest = Math.min(nearest, distanceToSegment(point, line.at(-1)!, line[0]!));
  return nearest;
}

/** Even-odd, as rooms are told. */
export function isInside(point: Point, polygon: readonly Point[]): boolean {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const a = polygon[i]!;
    const b = polygon[j]!;
    if (a.y > point.y !== b.y > point.y && point.x < ((b.x - a.x) * (point.y - a.y)) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

export function lengthOf(line: readonly Point[]): number {
  let length = 0;
  for (let i = 1; i < line.length; ++i) length += distance(line[i - 1]!, line[i]!);
  return length;
}

/** Where one is after so much of the way along the line, at most at its end, and which way it goes there. */
export function alongLine(line: readonly Point[], way: number): { point: Point; direction: Point } {
  let left = way;
  for (let i = 1; i < line.length; ++i) {
    const a = line[i - 1]!;
    const b = line[i]!;
    const step = distance(a, b);
    if (step > 0 && (left <= step || i === line.length - 1)) {
      return { point: pointBetween(a, b, Math.min(1, left / step)), direction: direction(a, b) };
    }
    left -= step;
  }
  return { point: line.at(-1) ?? { x: 0, y: 0 }, direction: { x: 1, y: 0 } };
}

/**
 * The line moved sideways, to its left where `by` is positive and y points up. Corners are mitred, at most four times as
 * far as the line is moved, so that a sharp turn does not shoot away.
 */
export function offsetLine(line: readonly Point[], by: number): Point[] {
  const points = line.filter((point, i) => i === 0 || distance(point, line[i - 1]!) > 0);
  if (points.length < 2) return [...points];
  return points.map((point, i) => {
    const before = i > 0 ? perpendicular(direction(points[i - 1]!, point)) : null;
    const after = i < points.length - 1 ? perpendicular(direction(point, points[i + 1]!)) : null;
    const first = before ?? after!;
    const second = after ?? before!;
    const sum = { x: first.x + second.x, y: first.y + second.y };
    const square = sum.x * sum.x + sum.y * sum.y;
    const mitre = square > 0.25 ? 2 / square : 0.5;
    return square < 1e-9 ? add(point, first, by) : add(point, sum, by * mitre);
  });
}

/** Counter-clockwise from `from`, in -pi .. pi. */
export function angleBetween(from: number, to: number): number {
  return Math.atan2(Math.sin(to - from), Math.cos(to - from));
}
