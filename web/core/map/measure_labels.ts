// Where the names of control measures stand.
import { alongLine, type Box, crosses, type Point } from "../geometry.ts";
import { type LabelWish, placeLabels, TakenBoxes } from "../labels.ts";
import type { MapSettings } from "../map_settings.ts";
import type { Measure, Scene } from "../protocol.ts";
import { kindOfWire } from "../tables/measures.ts";
import { colorOf, labelOf } from "./measure_names.ts";
import { boxOfMeasure, middleOf, shapeOf, signOf, sizeOf } from "./measure_shape.ts";
import { kSans, textWidth } from "./strokes.ts";
import type { Pen } from "./tool.ts";

export type LabelBox = Box;

export interface PlacedLabel {
  readonly text: string;
  readonly middle: Point;
  readonly box: LabelBox;
  readonly color: string;
  readonly font: string;
}

interface Key {
  readonly text: string;
  readonly color: string;
  readonly font: string;
}

/** @param bodies  what names don't cover either */
export function placeMeasureLabels(
  pen: Pen,
  scene: Scene,
  settings: MapSettings,
  bodies: readonly Box[] = [],
): PlacedLabel[] {
  if (!settings.layers.labels || !settings.layers.measures) return [];
  const lines = linesOnScreen(pen, scene);
  const cost = (box: Box): number => costOf(box, lines);
  const wishes = scene.measures.flatMap((measure) => wishOf(pen, measure)).map((wish) => ({ ...wish, cost }));
  const taken = new TakenBoxes([...signBoxes(pen, scene), ...bodies]);
  const { width, height } = pen.camera;
  return placeLabels(wishes, taken, { xMin: 4, yMin: 4, xMax: width - 4, yMax: height - 4 }).map(
    ({ key, box, middle }) => ({ ...key, box, middle }),
  );
}

function weightOf(measure: Measure): number {
  return kindOfWire(measure.kind)?.weight ?? 2;
}

function fontOf(measure: Measure, military: boolean): string {
  const isSoft = weightOf(measure) === 2;
  if (military) return `600 11.5px ${kSans}`;
  return isSoft ? `500 11px ${kSans}` : `600 12px ${kSans}`;
}

function wishOf(pen: Pen, measure: Measure): LabelWish<Key>[] {
  const text = labelOf(measure, pen.military);
  const first = measure.points[0];
  if (!text || !first) return [];
  const font = fontOf(measure, pen.military);
  const width = textWidth(pen, text, font) + 6;
  const height = 16;
  const color = colorOf(measure, pen.palette, pen.military);
  const weight = weightOf(measure);
  const sign = signOf(measure);
  const wish = (places: Point[], lighter = 0): LabelWish<Key> => ({
    key: { text, color, font },
    width,
    height,
    places,
    weight: weight - lighter,
  });
  const box = boxOfMeasure(measure)!;
  const extent = Math.max(box.xMax - box.xMin, box.yMax - box.yMin) * pen.camera.scale;
  // What is only a speck would be all name.
  const isPoint = sign === "point" || sign === "flag";
  if (!isPoint && extent < 14) return [];
  const both = pen.military && (sign === "line" || sign === "arcs");
  const places = placesOf(pen, measure, width, height);
  return both ? [wish(places), wish(otherEnd(pen, measure, height), 1)] : [wish(places)];
}

/** The best first. */
function placesOf(pen: Pen, measure: Measure, width: number, height: number): Point[] {
  const { camera } = pen;
  switch (signOf(measure)) {
    case "point": {
      const at = camera.toScreen(measure.points[0]!);
      if (pen.military) return aside(at, { x: 12, y: 34 }, width, height, -17);
      const radius = Math.max(4, (sizeOf(measure) / 2) * camera.scale);
      return aside(at, { x: radius + 2, y: radius + 2 }, width, height);
    }
    case "flag":
      return aside(camera.toScreen(measure.points[0]!), { x: 12, y: 34 }, width, height, -17);
    case "arcs":
    case "line":
      return lineEnds(pen, measure, width, height);
    case "boundary":
    case "wall":
    case "road":
    case "door": {
      const shape = shapeOf(measure)!;
      return shape.kind === "line"
        ? alongPlaces(pen, shape.points, width, height, shape.width)
        : areaPlaces(pen, measure, height);
    }
    case "rails": {
      const middle = camera.toScreen(middleOf(measure));
      const half = (sizeOf(measure) / 2) * camera.scale * 1.35 + height / 2 + 2;
      return [
        { x: middle.x, y: middle.y + half },
        { x: middle.x, y: middle.y - half },
        { x: middle.x + width / 2 + 4, y: middle.y },
        { x: middle.x - width / 2 - 4, y: middle.y },
        middle,
      ];
    }
    case "arrow": {
      const shares = [0.45, 0.3, 0.6, 0.15];
      const length = alongTotal(measure.points);
      return shares.map((share) => camera.toScreen(alongLine(measure.points, length * share).point));
    }
    case "area":
    case "held_area":
    case "landing_area":
    case "room":
    case "hallway":
      return areaPlaces(pen, measure, height);
  }
}

function alongTotal(points: readonly Point[]): number {
  let total = 0;
  for (let i = 1; i < points.length; ++i) {
    total += Math.hypot(points[i]!.x - points[i - 1]!.x, points[i]!.y - points[i - 1]!.y);
  }
  return total;
}

/** Below, right, left, above. `lift`: how far the sign's middle is above the place. */
function aside(at: Point, gap: Point, width: number, height: number, lift = 0): Point[] {
  const below = lift ? 4 : gap.y;
  return [
    { x: at.x, y: at.y + below + height / 2 },
    { x: at.x + gap.x + width / 2, y: at.y + lift },
    { x: at.x - gap.x - width / 2, y: at.y + lift },
    { x: at.x, y: at.y - gap.y - height / 2 },
    { x: at.x + gap.x * 0.7 + width / 2, y: at.y + below + height / 2 },
    { x: at.x - gap.x * 0.7 - width / 2, y: at.y + below + height / 2 },
  ];
}

function areaPlaces(pen: Pen, measure: Measure, height: number): Point[] {
  const { camera } = pen;
  const box = boxOfMeasure(measure)!;
  const middle = camera.toScreen(middleOf(measure));
  const top = camera.toScreenY(box.yMax);
  const low = camera.toScreenY(box.yMin);
  const quarter = (low - top) / 4;
  return [
    middle,
    { x: middle.x, y: middle.y - Math.max(quarter, height) },
    { x: middle.x, y: middle.y + Math.max(quarter, height) },
    { x: middle.x, y: low + height / 2 + 2 },
    { x: middle.x, y: top - height / 2 - 2 },
  ];
}

/** Below the lower end, then above the upper one, then beside the line. */
function lineEnds(pen: Pen, measure: Measure, width: number, height: number): Point[] {
  const { camera } = pen;
  const ends = [measure.points[0]!, measure.points.at(-1)!].map((point) => camera.toScreen(point));
  const [low, high] = ends[0]!.y >= ends[1]!.y ? ends : [ends[1]!, ends[0]!];
  const bottom = Math.min(low!.y + height / 2 + 4, camera.height - 4 - height / 2);
  const above = signOf(measure) === "arcs" ? 10 : 4; // its arcs
  return [
    { x: low!.x, y: bottom },
    { x: low!.x, y: bottom + height * 0.75 },
    { x: high!.x, y: high!.y - height / 2 - above },
    { x: high!.x, y: high!.y - height * 1.25 - above },
    ...alongPlaces(pen, measure.points, width, height, 0),
  ];
}

function otherEnd(pen: Pen, measure: Measure, height: number): Point[] {
  const ends = [measure.points[0]!, measure.points.at(-1)!].map((point) => pen.camera.toScreen(point));
  const high = ends[0]!.y < ends[1]!.y ? ends[0]! : ends[1]!;
  const above = signOf(measure) === "arcs" ? 10 : 4;
  const top = Math.max(high.y - height / 2 - above, 4 + height / 2);
  return [
    { x: high.x, y: top },
    { x: high.x, y: top - height * 0.75 },
  ];
}

function alongPlaces(pen: Pen, points: readonly Point[], text: number, height: number, width: number): Point[] {
  const length = alongTotal(points);
  const aside = (width / 2) * pen.camera.scale + text / 2 + 4;
  const away = (width / 2) * pen.camera.scale + height / 2 + 3;
  return [0.08, 0.92, 0.5, 0.3, 0.7].flatMap((share) => {
    const { point, direction } = alongLine(points, length * share);
    const at = pen.camera.toScreen(point);
    const steep = Math.abs(direction.y) > Math.abs(direction.x);
    return steep
      ? [
          { x: at.x + aside, y: at.y },
          { x: at.x - aside, y: at.y },
        ]
      : [
          { x: at.x, y: at.y - away },
          { x: at.x, y: at.y + away },
        ];
  });
}

type Segment = readonly [Point, Point];

const kMostSegments = 4000; // beyond, names may lie over lines: the map is full anyway

/** The outlines of all measures, which names should not lie over. */
function linesOnScreen(pen: Pen, scene: Scene): Segment[] {
  const segments: Segment[] = [];
  for (const measure of scene.measures) {
    const outline = outlineOnScreen(pen, measure);
    for (let i = 1; i < outline.length; ++i) segments.push([outline[i - 1]!, outline[i]!]);
    if (segments.length > kMostSegments) return [];
  }
  return segments;
}

function outlineOnScreen(pen: Pen, measure: Measure): Point[] {
  const shape = shapeOf(measure);
  if (!shape || shape.kind === "point" || signOf(measure) === "point") return [];
  const toScreen = (points: readonly Point[]): Point[] => points.map((point) => pen.camera.toScreen(point));
  if (shape.kind === "circle") {
    const { centre, radius } = shape;
    const corners = Array.from({ length: 25 }, (_, i) => (i / 24) * 2 * Math.PI);
    return toScreen(
      corners.map((angle) => ({ x: centre.x + radius * Math.cos(angle), y: centre.y + radius * Math.sin(angle) })),
    );
  }
  return toScreen(shape.kind === "polygon" ? [...shape.points, shape.points[0]!] : shape.points);
}

/** A line through the middle hides more of the name than one along its edge. */
function costOf(box: Box, lines: readonly Segment[]): number {
  const inner = { xMin: box.xMin + 3, xMax: box.xMax - 3, yMin: box.yMin + 3, yMax: box.yMax - 3 };
  let cost = 0;
  for (const [a, b] of lines) {
    if (crosses(inner, a, b)) cost += 2;
    else if (crosses(box, a, b)) cost += 1;
  }
  return cost;
}

/** Small signs that a name must not hide. */
function signBoxes(pen: Pen, scene: Scene): Box[] {
  const { camera } = pen;
  return scene.measures.flatMap((measure) => {
    const first = measure.points[0];
    if (!first) return [];
    const { x, y } = camera.toScreen(first);
    const isFlag = signOf(measure) === "flag" || (pen.military && signOf(measure) === "point");
    if (isFlag) return [{ xMin: x - 11, xMax: x + 11, yMin: y - 33, yMax: y + 2 }];
    if (signOf(measure) !== "point") return [];
    const radius = Math.max(4, (sizeOf(measure) / 2) * camera.scale);
    return radius > 40 ? [] : [{ xMin: x - radius, xMax: x + radius, yMin: y - radius, yMax: y + radius }];
  });
}
