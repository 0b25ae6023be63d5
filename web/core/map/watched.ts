// All that is known of watched robots: readings, what they perceive, what moves them, where they go, where they belong.
import { type Box, distance, type Point } from "../geometry.ts";
import { boxAround, type LabelWish, placeLabels, TakenBoxes } from "../labels.ts";
import type { Model } from "../model.ts";
import { toFloats } from "../packed.ts";
import { spokenPath } from "../port_words.ts";
import type { RobotDetail } from "../protocol.ts";
import { fade } from "./palette.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { arrow, fill, isOnScreen, kSans, stroke, textWidth, traceCircle, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";
import type { TopState } from "./top.ts";

const kMostDetailed = 8; // robots whose readings and contributions are shown; beyond it would be a tangle
const kFullStrength = 64; // px of a contribution of strength 1
const kNothing = 0.02; // a strength that is not drawn
const kNameFont = `600 10.5px ${kSans}`;

/** Returns the boxes of the names it wrote. */
export function drawWatched(pen: Pen, model: Model, { styles, taken }: TopState): Box[] {
  const selected = model.get("selection").robots;
  // Where the robot is drawn, which may be on its way to where its detail has it.
  const details = selected.flatMap((id) => {
    const detail = model.detail(id);
    return detail ? { ...detail, ...model.placeOf(id) } : [];
  });
  const settings = model.get("map");
  const close = details.slice(0, kMostDetailed);
  if (settings.layers.readings) for (const detail of close) drawReadings(pen, detail);
  if (settings.highlightObstacles) for (const detail of close) drawPerceived(pen, detail);
  for (const detail of details) drawWays(pen, detail);
  for (const detail of details) drawGoal(pen, detail, styles);
  for (const detail of details) drawStation(pen, detail, styles);
  if (!settings.contributions) return [];
  const arrows = close.map((detail) => drawContributions(pen, detail, styles));
  // Names of schemas are only told of one robot: more can't be read.
  const names = close.length === 1 ? nameContributions(pen, arrows[0]!, taken) : [];
  return [...names, ...arrows.flat().flatMap(boxesAlong)];
}

function screenOf(pen: Pen, { x, y }: Point): Point {
  return pen.camera.toScreen({ x, y });
}

/** What the sensors see: the free ground between the rays, and a dot at each hit. */
function drawReadings(pen: Pen, detail: RobotDetail): void {
  const values = toFloats(detail.ranges);
  if (values.length < 3) return;
  const { context, palette } = pen;
  const from = screenOf(pen, detail);
  const ends: { at: Point; isHit: boolean; angle: number }[] = [];
  for (let i = 0; i + 2 < values.length; i += 3) {
    const angle = detail.heading + values[i]!;
    const range = values[i + 1]!;
    if (!Number.isFinite(range)) continue;
    const at = screenOf(pen, { x: detail.x + Math.cos(angle) * range, y: detail.y + Math.sin(angle) * range });
    ends.push({ at, isHit: values[i + 2]! > 0.5, angle });
  }
  context.beginPath();
  ends.forEach(({ at }, i) => {
    if (i === 0) context.moveTo(at.x, at.y);
    else context.lineTo(at.x, at.y);
  });
  context.closePath();
  fill(pen, fade(palette.reading, 0.07));
  context.beginPath();
  for (const { at } of ends) {
    context.moveTo(from.x, from.y);
    context.lineTo(at.x, at.y);
  }
  stroke(pen, { color: fade(palette.reading, 0.28), width: 1 });
  context.beginPath();
  for (const { at, isHit } of ends) {
    if (!isHit) continue;
    context.moveTo(at.x + 2.75, at.y);
    context.arc(at.x, at.y, 2.75, 0, 2 * Math.PI);
  }
  fill(pen, palette.reading);
}

/** Obstacles as the robot perceives them, over what they are. */
function drawPerceived(pen: Pen, detail: RobotDetail): void {
  const values = toFloats(detail.obstacles);
  const { palette } = pen;
  for (let i = 0; i + 2 < values.length; i += 3) {
    traceCircle(pen, { x: values[i]!, y: values[i + 1]! }, values[i + 2]!, 3);
    fill(pen, fade(palette.repelling, 0.35));
    stroke(pen, { color: palette.repelling, width: 2 });
  }
}

/** The ways that its program has planned. */
function drawWays(pen: Pen, detail: RobotDetail): void {
  const values = toFloats(detail.ways);
  const { context, palette } = pen;
  let isFirst = true;
  context.beginPath();
  for (let i = 0; i + 1 < values.length; i += 2) {
    const corner = { x: values[i]!, y: values[i + 1]! };
    if (Number.isNaN(corner.x)) {
      isFirst = true;
      continue;
    }
    const at = screenOf(pen, corner);
    if (isFirst) context.moveTo(at.x, at.y);
    else context.lineTo(at.x, at.y);
    isFirst = false;
  }
  stroke(pen, { color: palette.halo, width: 4 });
  stroke(pen, { color: palette.goal, width: 1.75 });
}

function drawGoal(pen: Pen, detail: RobotDetail, styles: RobotStyles): void {
  if (!detail.goal) return;
  const { context, palette, camera } = pen;
  const from = screenOf(pen, detail);
  const to = screenOf(pen, detail.goal);
  const away = distance(from, to);
  const body = styles.pixels(detail.id, camera.scale) * 0.7;
  const hasWay = detail.ways.length > 0;
  if (away > body + 8 && !hasWay) {
    context.beginPath();
    context.moveTo(from.x + ((to.x - from.x) * body) / away, from.y + ((to.y - from.y) * body) / away);
    context.lineTo(to.x - ((to.x - from.x) * 7) / away, to.y - ((to.y - from.y) * 7) / away);
    stroke(pen, { color: palette.goal, width: 1.5, dash: [7, 5] });
  }
  if (!isOnScreen(camera, to.x, to.y)) return;
  context.beginPath();
  context.arc(to.x, to.y, 6, 0, 2 * Math.PI);
  stroke(pen, { color: palette.halo, width: 4 });
  stroke(pen, { color: palette.goal, width: 2 });
  context.beginPath();
  context.arc(to.x, to.y, 2, 0, 2 * Math.PI);
  fill(pen, palette.goal);
}

/** Where the formation wants the robot, and the line of its error. */
function drawStation(pen: Pen, detail: RobotDetail, styles: RobotStyles): void {
  if (!detail.station) return;
  const { context, palette, camera } = pen;
  const from = screenOf(pen, detail);
  const to = screenOf(pen, detail.station);
  const body = styles.pixels(detail.id, camera.scale) / 2;
  if (distance(from, to) > body) {
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
    stroke(pen, { color: palette.station, width: 1.5, dash: [3, 3] });
  }
  context.beginPath();
  context.moveTo(to.x - 6, to.y);
  context.lineTo(to.x + 6, to.y);
  context.moveTo(to.x, to.y - 6);
  context.lineTo(to.x, to.y + 6);
  stroke(pen, { color: palette.halo, width: 4 });
  stroke(pen, { color: palette.station, width: 2 });
}

interface Contribution {
  readonly name: string;
  readonly color: string;
  readonly tip: Point;
  readonly way: Point; // from the robot's middle to the tip [px]
}

/** Each schema's push in a colour of its own, and their sum. */
function drawContributions(pen: Pen, detail: RobotDetail, styles: RobotStyles): Contribution[] {
  const { palette, camera } = pen;
  const from = screenOf(pen, detail);
  const full = Math.max(kFullStrength, styles.pixels(detail.id, camera.scale) * 1.1);
  const tipOf = (x: number, y: number): Point => {
    const { x: dx, y: dy } = toScreenVector(x, y, detail.heading, full);
    return { x: from.x + dx, y: from.y + dy };
  };
  const arrows: Contribution[] = [];
  let sumX = 0;
  let sumY = 0;
  detail.contributions.forEach(({ x, y, member }, i) => {
    sumX += x;
    sumY += y;
    if (Math.hypot(x, y) < kNothing) return;
    const color = palette.contributions[i % palette.contributions.length]!;
    const tip = tipOf(x, y);
    arrow(pen, from, tip, { color: palette.halo, width: 4.5 }, 9);
    arrow(pen, from, tip, { color, width: 2.25 }, 9);
    arrows.push({ name: spokenPath(member), color, tip, way: { x: tip.x - from.x, y: tip.y - from.y } });
  });
  if (arrows.length > 1 && Math.hypot(sumX, sumY) >= kNothing) {
    const tip = tipOf(sumX, sumY);
    arrow(pen, from, tip, { color: palette.halo, width: 5 }, 12);
    arrow(pen, from, tip, { color: palette.ink, width: 3 }, 12);
    arrows.push({ name: "", color: palette.ink, tip, way: { x: tip.x - from.x, y: tip.y - from.y } });
  }
  return arrows;
}

/** Small boxes from the arrow's middle to its tip, over which no name should lie. */
function boxesAlong({ tip, way }: Contribution): Box[] {
  return [0, 0.25, 0.5].map((back) => boxAround({ x: tip.x - way.x * back, y: tip.y - way.y * back }, 8, 8));
}

/** A push of the robot's frame as pixels: beyond full strength it grows no more than half as far again. */
function toScreenVector(x: number, y: number, heading: number, full: number): Point {
  const strength = Math.hypot(x, y);
  if (strength === 0) return { x: 0, y: 0 };
  const factor = (full * Math.min(strength, 1 + 0.5 * Math.tanh(strength - 1))) / strength;
  const c = Math.cos(heading);
  const s = Math.sin(heading);
  return { x: (x * c - y * s) * factor, y: -(x * s + y * c) * factor };
}

/** Beyond the tips, where they don't lie over one another. */
function nameContributions(pen: Pen, arrows: readonly Contribution[], taken: readonly Box[]): Box[] {
  const named = arrows.filter(({ name }) => name !== "");
  const wishes = named.map((key): LabelWish<Contribution> => {
    const width = textWidth(pen, key.name, kNameFont) + 4;
    const length = Math.max(1, Math.hypot(key.way.x, key.way.y));
    const ux = key.way.x / length;
    const uy = key.way.y / length;
    const at = (away: number, down: number): Point => ({
      x: key.tip.x + ux * away + Math.max(-1, Math.min(1, ux * 2)) * (width / 2),
      y: key.tip.y + uy * (away + 4) + down,
    });
    const places = [at(6, 0), at(6, 12), at(6, -12), at(20, 0), at(20, 14), at(20, -14), at(34, 0)];
    return { key, width, height: 13, weight: length, places };
  });
  const { width, height } = pen.camera;
  const placed = placeLabels(wishes, new TakenBoxes(taken), { xMin: 2, yMin: 2, xMax: width - 2, yMax: height - 2 });
  for (const { key, middle } of placed) writeText(pen, key.name, middle.x, middle.y, key.color, kNameFont);
  return placed.map(({ box }) => box);
}
