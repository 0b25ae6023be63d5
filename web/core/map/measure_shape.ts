// What a control measure covers in the world: drawn, hit by the pointer and fitted to the screen alike.
import {
  add,
  type Box,
  boundsOf,
  centreOf,
  direction,
  distance,
  distanceToLine,
  grow,
  isInside,
  offsetLine,
  type Point,
  perpendicular,
  pointBetween,
} from "../geometry.ts";
import type { Measure } from "../protocol.ts";
import { kindOfWire, type MeasureSign } from "../tables/measures.ts";

export type Shape =
  | { readonly kind: "circle"; readonly centre: Point; readonly radius: number }
  | { readonly kind: "polygon"; readonly points: readonly Point[] }
  | { readonly kind: "line"; readonly points: readonly Point[]; readonly width: number }
  | { readonly kind: "point"; readonly at: Point };

/** Its diameter or width [m]. */
export function sizeOf(measure: Measure): number {
  return measure.size > 0 ? measure.size : (kindOfWire(measure.kind)?.defaultSize ?? 0);
}

/** What stands for it; of a kind of a newer server just its line. */
export function signOf(measure: Measure): MeasureSign {
  return kindOfWire(measure.kind)?.sign ?? "line";
}

/** null of a measure without points. */
export function shapeOf(measure: Measure): Shape | null {
  const { points } = measure;
  const first = points[0];
  if (!first) return null;
  switch (signOf(measure)) {
    case "area":
    case "held_area":
    case "landing_area":
      return points.length === 1
        ? { kind: "circle", centre: first, radius: sizeOf(measure) / 2 }
        : { kind: "polygon", points };
    case "point":
      return { kind: "circle", centre: first, radius: sizeOf(measure) / 2 };
    case "flag":
      return { kind: "point", at: first };
    case "arrow":
      return points.length < 2 ? { kind: "point", at: first } : { kind: "polygon", points: axisOutline(measure) };
    case "rails":
      return points.length < 2
        ? { kind: "point", at: first }
        : { kind: "line", points: points.slice(0, 2), width: sizeOf(measure) };
    case "boundary":
      if (points.length === 1) return { kind: "circle", centre: first, radius: 25 };
      return isClosed(measure) ? { kind: "polygon", points } : { kind: "line", points, width: 0 };
    case "room":
      return points.length > 2 ? { kind: "polygon", points } : { kind: "line", points, width: 0 };
    case "hallway":
      if (points.length > 2) return { kind: "polygon", points };
      return {
        kind: "line",
        points: measure.centerline.length > 1 ? measure.centerline : points,
        width: sizeOf(measure),
      };
    case "road":
      return { kind: "line", points, width: sizeOf(measure) };
    case "arcs":
      return { kind: "line", points: points.length > 1 ? [first, points.at(-1)!] : points, width: 0 };
    case "line":
    case "wall":
    case "door":
      return { kind: "line", points, width: 0 };
  }
}

/** Whether a line comes back to where it began. */
export function isClosed(measure: Measure): boolean {
  const { points } = measure;
  return points.length > 3 && distance(points[0]!, points.at(-1)!) < 1e-6;
}

/** A broad arrow along the points, its tip at the last; the tail's two corners are first and last. */
export function axisOutline(measure: Measure): Point[] {
  const points = measure.points.filter((point, i) => i === 0 || distance(point, measure.points[i - 1]!) > 0);
  const tip = points.at(-1)!;
  const before = points.at(-2);
  if (!before) return points;
  const width = sizeOf(measure);
  const leg = distance(before, tip);
  const head = Math.min(width, leg * 0.8);
  const ahead = direction(before, tip);
  const side = perpendicular(ahead);
  const neck = add(tip, ahead, -head);
  const shaft = [...points.slice(0, -1), neck];
  const left = offsetLine(shaft, width / 2);
  const right = offsetLine(shaft, -width / 2);
  return [...left, add(neck, side, width * 0.7), tip, add(neck, side, -width * 0.7), ...right.reverse()];
}

/** The two rails, each with its flared ends, as lines of four points. */
export function gapRails(measure: Measure): Point[][] {
  const [a, b] = measure.points;
  if (!a || !b) return [];
  const width = sizeOf(measure);
  const along = direction(a, b);
  const side = perpendicular(along);
  const flare = Math.min(width / 6, distance(a, b)) || width / 6;
  return [1, -1].map((hand) => {
    const rail = (from: Point, out: number): Point => add(from, side, (hand * width) / 2 + hand * out);
    return [
      add(rail(a, width / 6), along, -flare * 0.6),
      rail(a, 0),
      rail(b, 0),
      add(rail(b, width / 6), along, flare * 0.6),
    ];
  });
}

export function boxOfMeasure(measure: Measure): Box | null {
  const shape = shapeOf(measure);
  if (!shape) return null;
  if (shape.kind === "circle") {
    return grow(
      { xMin: shape.centre.x, yMin: shape.centre.y, xMax: shape.centre.x, yMax: shape.centre.y },
      shape.radius,
    );
  }
  if (shape.kind === "point") return boundsOf([shape.at]);
  return grow(boundsOf(shape.points)!, shape.kind === "line" ? shape.width / 2 : 0);
}

/**
 * How far the point is from the measure's drawing [m], and whether it lies inside of what it encloses.
 * @param reach  within this distance a sign without extent (a starting point's flag) is hit [m]
 */
export function distanceTo(measure: Measure, point: Point, reach: number): { edge: number; isInside: boolean } {
  const shape = shapeOf(measure);
  if (!shape) return { edge: Infinity, isInside: false };
  switch (shape.kind) {
    case "circle": {
      const away = distance(shape.centre, point);
      return { edge: Math.abs(away - shape.radius), isInside: away <= shape.radius };
    }
    case "polygon":
      return { edge: distanceToLine(point, shape.points, true), isInside: isInside(point, shape.points) };
    case "line": {
      const away = distanceToLine(point, shape.points);
      return { edge: Math.abs(away - shape.width / 2), isInside: away <= shape.width / 2 };
    }
    case "point": {
      // The flag stands above its tip.
      const away = Math.min(distance(shape.at, point), distance(add(shape.at, { x: 0, y: reach * 6 }), point));
      return { edge: away / 3, isInside: false };
    }
  }
}

/** A place on the measure that a label or a line can point at: the middle of what is drawn. */
export function middleOf(measure: Measure): Point {
  const { points } = measure;
  if (signOf(measure) === "rails" && points.length > 1) return pointBetween(points[0]!, points[1]!, 0.5);
  return centreOf(isClosed(measure) ? points.slice(1) : points);
}
