// Control measures in the plain style: outlines and light fills, told apart by colour and shape.
import { add, direction, distance, type Point, perpendicular } from "../geometry.ts";
import type { Measure } from "../protocol.ts";
import { kindOfWire, type MeasureSign } from "../tables/measures.ts";
import { colorOf } from "./measure_names.ts";
import { gapRails, isClosed, type Shape, shapeOf, signOf, sizeOf } from "./measure_shape.ts";
import { fade } from "./palette.ts";
import { fill, hatch, stroke, trace, traceCircle } from "./strokes.ts";
import type { Pen } from "./tool.ts";

/** Draws the sign of a measure. `color` is that of the style. */
export type DrawSign = (pen: Pen, measure: Measure, shape: Shape, color: string) => void;

/** The same in both styles. */
export const kBuildingSigns = {
  wall: (pen, measure) => {
    trace(pen, measure.points);
    stroke(pen, { color: pen.palette.wall, width: Math.max(2.5, Math.min(7, 0.2 * pen.camera.scale)) });
  },
  room: (pen, _, shape) => {
    traceShape(pen, shape);
    if (shape.kind === "polygon") fill(pen, pen.palette.room);
    stroke(pen, { color: pen.palette.roomEdge, width: 1 });
  },
  hallway: drawHallway,
  door: drawDoor,
  road: (pen, _, shape) => drawRoad(pen, shape),
} satisfies Partial<Record<MeasureSign, DrawSign>>;

/** Inside of the shape that was traced, where its kind wants it. */
export const hatchInside: DrawSign = (pen, measure, shape, color) => {
  if (!kindOfWire(measure.kind)?.isHatched) return;
  hatch(pen, fade(color, 0.4), 14, true);
  traceShape(pen, shape);
};

function plainArea(dash: readonly number[]): DrawSign {
  return (pen, measure, shape, color) => {
    traceShape(pen, shape);
    fill(pen, fade(color, pen.palette.isDark ? 0.12 : 0.08));
    hatchInside(pen, measure, shape, color);
    stroke(pen, { color, width: 1.75, dash });
  };
}

/** Of the broken outline of a landing zone, in both styles. */
export const kLandingDash = [14, 5];

const kPlainSigns: Readonly<Record<MeasureSign, DrawSign>> = {
  ...kBuildingSigns,
  area: plainArea([]),
  held_area: plainArea([]),
  landing_area: plainArea(kLandingDash),
  point: (pen, measure, _, color) => drawPassagePoint(pen, measure, color),
  flag: (pen, measure, _, color) => drawFlag(pen, measure.points[0]!, color, true),
  arrow: (pen, _, shape, color) => {
    traceShape(pen, shape);
    fill(pen, fade(color, pen.palette.isDark ? 0.1 : 0.06));
    stroke(pen, { color, width: 1.75 });
  },
  line: (pen, measure, _, color) => {
    trace(pen, measure.points);
    stroke(pen, { color, width: 2 });
  },
  arcs: (pen, measure, _, color) => drawArcs(pen, measure, color),
  rails: (pen, measure, _, color) => drawGap(pen, measure, color),
  boundary: drawBoundary,
};

export function drawPlain(pen: Pen, measure: Measure): void {
  const shape = shapeOf(measure);
  if (shape) kPlainSigns[signOf(measure)](pen, measure, shape, colorOf(measure, pen.palette, false));
}

export function traceShape(pen: Pen, shape: Shape): void {
  if (shape.kind === "circle") traceCircle(pen, shape.centre, shape.radius, 3);
  else if (shape.kind === "point") traceCircle(pen, shape.at, 0, 3);
  else trace(pen, shape.points, shape.kind === "polygon");
}

function drawPassagePoint(pen: Pen, measure: Measure, color: string): void {
  const { palette } = pen;
  const centre = measure.points[0]!;
  traceCircle(pen, centre, sizeOf(measure) / 2, 4);
  fill(pen, fade(palette.ground, 0.9));
  stroke(pen, { color, width: 2 });
  if ((sizeOf(measure) / 2) * pen.camera.scale > 9) {
    traceCircle(pen, centre, 0, 2);
    fill(pen, color);
  }
}

/** A box above a tip that touches the place, as points for action are drawn; 20 pixels wide at every scale. */
export function drawFlag(pen: Pen, place: Point, color: string, isFilled: boolean, text = ""): void {
  const { context, camera, palette } = pen;
  const { x, y } = camera.toScreen(place);
  const top = y - 32;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - 10, y - 11);
  context.lineTo(x - 10, top);
  context.lineTo(x + 10, top);
  context.lineTo(x + 10, y - 11);
  context.closePath();
  fill(pen, palette.ground);
  if (isFilled) fill(pen, fade(color, 0.14));
  stroke(pen, { color, width: 1.75 });
  if (!text) return;
  context.fillStyle = color;
  context.font = `700 10.5px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, x, top + 11);
}

/** Half circles in a row from the first to the last point, bulging to the left of the way along it. */
export function drawArcs(pen: Pen, measure: Measure, color: string, width = 1.75): void {
  const { context, camera } = pen;
  const from = camera.toScreen(measure.points[0]!);
  const to = camera.toScreen(measure.points.at(-1)!);
  const length = distance(from, to);
  if (length < 2) return;
  // About 20 m each, but neither specks nor fewer than eight.
  const wanted = Math.max(9, Math.min(20 * camera.scale, length / 8));
  const count = Math.max(1, Math.round(length / wanted));
  const radius = length / count / 2;
  const along = direction(from, to);
  const angle = Math.atan2(along.y, along.x);
  context.beginPath();
  for (let i = 0; i < count; ++i) {
    const middle = add(from, along, (2 * i + 1) * radius);
    context.moveTo(middle.x - along.x * radius, middle.y - along.y * radius);
    context.arc(middle.x, middle.y, radius, angle + Math.PI, angle + 2 * Math.PI);
  }
  stroke(pen, { color, width });
}

export function drawGap(pen: Pen, measure: Measure, color: string, width = 2): void {
  for (const rail of gapRails(measure)) {
    trace(pen, rail);
    stroke(pen, { color, width });
  }
}

/** Zones are hatched, each kind its own way; other boundaries are plain lines. */
export function drawBoundary(pen: Pen, measure: Measure, shape: Shape, color: string): void {
  if (!measure.zone) {
    traceShape(pen, shape);
    stroke(pen, { color, width: 1.5, dash: [10, 4] });
    return;
  }
  const dashes: Record<string, number[]> = { weather: [2, 5], "no-fly": [], "no-communication": [8, 3, 2, 3] };
  if (shape.kind !== "line" || isClosed(measure)) {
    traceShape(pen, shape);
    fill(pen, fade(color, 0.07));
    if (measure.zone === "weather") hatch(pen, fade(color, 0.4), 14, true);
    if (measure.zone === "no-communication") hatch(pen, fade(color, 0.4), 14, false);
    if (measure.zone === "no-fly") {
      hatch(pen, fade(color, 0.3), 18, true);
      traceShape(pen, shape);
      hatch(pen, fade(color, 0.3), 18, false);
    }
  }
  traceShape(pen, shape);
  stroke(pen, { color, width: 2, dash: dashes[measure.zone] ?? [10, 4] });
}

function drawHallway(pen: Pen, measure: Measure, shape: Shape): void {
  const { palette, camera } = pen;
  if (shape.kind === "polygon") {
    traceShape(pen, shape);
    fill(pen, palette.room);
    stroke(pen, { color: palette.roomEdge, width: 1 });
  } else if (shape.kind === "line") {
    drawBand(pen, shape.points, Math.max(4, shape.width * camera.scale), palette.room, palette.roomEdge);
  }
  if (measure.centerline.length > 1) {
    trace(pen, measure.centerline);
    stroke(pen, { color: palette.roomEdge, width: 1, dash: [6, 5] });
  }
}

function drawRoad(pen: Pen, shape: Shape): void {
  if (shape.kind !== "line") return;
  const { palette, camera } = pen;
  const width = Math.max(4, shape.width * camera.scale);
  drawBand(pen, shape.points, width, palette.road, palette.roadEdge);
  if (width < 10) return;
  trace(pen, shape.points);
  stroke(pen, { color: palette.roadEdge, width: 1.25, dash: [8, 8] });
}

function drawBand(pen: Pen, points: readonly Point[], width: number, inside: string, edge: string): void {
  trace(pen, points);
  stroke(pen, { color: edge, width: width + 2 });
  trace(pen, points);
  stroke(pen, { color: inside, width });
}

/** An opening with its leaf standing open and the way it swings, as plans of buildings have it. */
function drawDoor(pen: Pen, measure: Measure): void {
  const { context, camera, palette } = pen;
  const [a, b] = measure.points;
  if (!a || !b) return;
  const hinge = camera.toScreen(a);
  const end = camera.toScreen(b);
  const width = distance(hinge, end);
  context.beginPath();
  context.moveTo(hinge.x, hinge.y);
  context.lineTo(end.x, end.y);
  stroke(pen, { color: palette.ground, width: Math.max(4, Math.min(9, 0.25 * camera.scale)) });
  if (width < 6) return;
  const along = direction(hinge, end);
  const leaf = add(hinge, perpendicular(along), -width);
  const angle = Math.atan2(along.y, along.x);
  context.beginPath();
  context.arc(hinge.x, hinge.y, width, angle - Math.PI / 2, angle);
  stroke(pen, { color: palette.softInk, width: 1, dash: [3, 3] });
  context.beginPath();
  context.moveTo(hinge.x, hinge.y);
  context.lineTo(leaf.x, leaf.y);
  stroke(pen, { color: palette.wall, width: 2 });
}
