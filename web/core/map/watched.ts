// All that is known of watched robots: readings, what they perceive, what moves them, where they go, where they belong.
import { distance, type Point } from "../geometry.ts";
import type { Model } from "../model.ts";
import { toFloats } from "../packed.ts";
import type { RobotDetail } from "../protocol.ts";
import { fade } from "./palette.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { arrow, fill, isOnScreen, kSans, stroke, traceCircle, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kMostDetailed = 8; // robots whose readings and contributions are shown; beyond it would be a tangle
const kFullStrength = 56; // px of a contribution of strength 1

export function drawWatched(pen: Pen, model: Model, styles: RobotStyles): void {
  const selected = model.get("selection").robots;
  const details = selected.flatMap((id) => model.detail(id) ?? []);
  const settings = model.get("map");
  const close = details.slice(0, kMostDetailed);
  if (settings.layers.readings) for (const detail of close) drawReadings(pen, detail);
  if (settings.highlightObstacles) for (const detail of close) drawPerceived(pen, detail);
  for (const detail of details) drawGoal(pen, detail, styles);
  for (const detail of details) drawStation(pen, detail, styles);
  for (const [i, detail] of close.entries()) {
    // Names of schemas are only told of one robot: more can't be read.
    if (settings.contributions) drawContributions(pen, detail, i === 0 && close.length <= 3);
  }
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

function drawGoal(pen: Pen, detail: RobotDetail, styles: RobotStyles): void {
  if (!detail.goal) return;
  const { context, palette, camera } = pen;
  const from = screenOf(pen, detail);
  const to = screenOf(pen, detail.goal);
  const away = distance(from, to);
  const body = styles.pixels(detail.id, camera.scale) * 0.7;
  if (away > body + 8) {
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

/** Each schema's push in a colour of its own, and their sum. */
function drawContributions(pen: Pen, detail: RobotDetail, named: boolean): void {
  const { palette } = pen;
  const from = screenOf(pen, detail);
  const c = Math.cos(detail.heading);
  const s = Math.sin(detail.heading);
  const end = (x: number, y: number): Point => {
    const strength = Math.hypot(x, y);
    // Beyond full strength the arrow grows no more than half as far again.
    const pixels = kFullStrength * Math.min(strength, 1 + 0.5 * Math.tanh(strength - 1));
    const factor = strength > 0 ? pixels / strength : 0;
    return { x: from.x + (x * c - y * s) * factor, y: from.y - (x * s + y * c) * factor };
  };
  let sumX = 0;
  let sumY = 0;
  detail.contributions.forEach((contribution, i) => {
    sumX += contribution.x;
    sumY += contribution.y;
    if (Math.hypot(contribution.x, contribution.y) < 0.02) return;
    const color = palette.contributions[i % palette.contributions.length]!;
    const to = end(contribution.x, contribution.y);
    arrow(pen, from, to, { color: palette.halo, width: 4 }, 8);
    arrow(pen, from, to, { color, width: 2 }, 9);
    if (!named || distance(from, to) < 14) return;
    const away = distance(from, to);
    const x = to.x + ((to.x - from.x) / away) * 8;
    const y = to.y + ((to.y - from.y) / away) * 10;
    writeBeside(pen, contribution.member, x, y, to.x - from.x, color);
  });
  if (detail.contributions.length > 1 && Math.hypot(sumX, sumY) >= 0.02) {
    arrow(pen, from, end(sumX, sumY), { color: palette.ink, width: 3 }, 11);
  }
}

/** The name begins, or ends, at the arrow, so that it doesn't lie over it. */
function writeBeside(pen: Pen, text: string, x: number, y: number, dx: number, color: string): void {
  const font = `600 10.5px ${kSans}`;
  pen.context.font = font;
  const half = pen.context.measureText(text).width / 2;
  writeText(pen, text, x + Math.max(-1, Math.min(1, dx / 12)) * half, y, color, font);
}
