// Control measures as tactical graphics, drawn from what MIL-STD-2525 says of each: friendly ones in one ink, told apart
// by shape and letters; where the standard has no sign for a thing, it looks as in the plain style.
import { add, alongLine, direction, lengthOf, type Point, perpendicular, pointBetween } from "../geometry.ts";
import type { Measure } from "../protocol.ts";
import { kindOfWire, type MeasureSign } from "../tables/measures.ts";
import { colorOf } from "./measure_names.ts";
import { axisOutline, shapeOf, signOf, sizeOf } from "./measure_shape.ts";
import {
  type DrawSign,
  drawArcs,
  drawBoundary,
  drawFlag,
  drawGap,
  hatchInside,
  kBuildingSigns,
  kLandingDash,
  traceShape,
} from "./measures_plain.ts";
import { fade } from "./palette.ts";
import { fill, stroke, trace } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kLine = 2.25;

function area(dash: readonly number[]): DrawSign {
  return (pen, measure, shape, color) => {
    traceShape(pen, shape);
    fill(pen, fade(pen.palette.ground, 0.35));
    hatchInside(pen, measure, shape, color);
    stroke(pen, { color, width: kLine, dash });
  };
}
const drawArea = area([]);

const drawCodeFlag: DrawSign = (pen, measure, _, color) =>
  drawFlag(pen, measure.points[0]!, color, false, kindOfWire(measure.kind)?.keyword);

const kMilitarySigns: Readonly<Record<MeasureSign, DrawSign>> = {
  ...kBuildingSigns,
  area: drawArea,
  held_area: (pen, measure, shape, color) => {
    drawArea(pen, measure, shape, color);
    drawEchelon(pen, measure, color);
  },
  landing_area: area(kLandingDash),
  point: drawCodeFlag,
  flag: drawCodeFlag,
  arrow: (pen, measure, _, color) => drawAxis(pen, measure, color),
  line: (pen, measure, _, color) => {
    trace(pen, measure.points);
    stroke(pen, { color, width: kLine });
  },
  arcs: (pen, measure, _, color) => drawArcs(pen, measure, color, kLine),
  rails: (pen, measure, _, color) => drawGap(pen, measure, color, kLine),
  boundary: (pen, measure, shape, color) => {
    if (measure.zone) drawBoundary(pen, measure, shape, color);
    else drawUnitBoundary(pen, measure, color);
  },
};

export function drawMilitary(pen: Pen, measure: Measure): void {
  const shape = shapeOf(measure);
  if (shape) kMilitarySigns[signOf(measure)](pen, measure, shape, colorOf(measure, pen.palette, true));
}

/** The axis of a supporting attack: the arrow's tail stays open, its head has one point. */
function drawAxis(pen: Pen, measure: Measure, color: string): void {
  if (measure.points.length < 2) return;
  trace(pen, axisOutline(measure), false);
  stroke(pen, { color, width: kLine });
}

/** A unit's size on the line of its battle position: a section, two dots. */
function drawEchelon(pen: Pen, measure: Measure, color: string): void {
  const { context, camera, palette } = pen;
  const shape = shapeOf(measure)!;
  const at =
    shape.kind === "circle"
      ? camera.toScreen(add(shape.centre, { x: 0, y: shape.radius }))
      : camera.toScreen(pointBetween(measure.points[0]!, measure.points[1] ?? measure.points[0]!, 0.5));
  if (sizeOf(measure) * camera.scale < 24) return;
  context.fillStyle = palette.ground;
  context.fillRect(at.x - 10, at.y - 4, 20, 8);
  drawDots(pen, at, { x: 1, y: 0 }, color);
}

function drawDots(pen: Pen, at: Point, along: Point, color: string): void {
  const { context } = pen;
  for (const side of [-4, 4]) {
    context.beginPath();
    context.arc(at.x + along.x * side, at.y + along.y * side, 2.5, 0, 2 * Math.PI);
    fill(pen, color);
  }
}

/** Between units: a line that their size interrupts in the middle. */
function drawUnitBoundary(pen: Pen, measure: Measure, color: string): void {
  const { context, camera } = pen;
  const shape = shapeOf(measure)!;
  traceShape(pen, shape);
  stroke(pen, { color, width: kLine });
  if (shape.kind !== "line") return;
  const length = lengthOf(shape.points);
  if (length * camera.scale < 120) return;
  const { point, direction: ahead } = alongLine(shape.points, length / 2);
  const at = camera.toScreen(point);
  const along = direction({ x: 0, y: 0 }, { x: ahead.x, y: -ahead.y });
  const a = add(at, along, -12);
  const b = add(at, along, 12);
  const side = perpendicular(along);
  context.beginPath();
  context.moveTo(a.x, a.y);
  context.lineTo(b.x, b.y);
  stroke(pen, { color: pen.palette.ground, width: 5 });
  drawDots(pen, add(at, side, 0), along, color);
}
