// Robots that have not been started, where START will put them: outlines, so that nobody takes them for the real ones.
import { idRanges } from "../format.ts";
import { type Box, contains } from "../geometry.ts";
import { clustersOf, type LabelWish, placeLabels, TakenBoxes } from "../labels.ts";
import type { Model } from "../model.ts";
import type { RobotTable } from "../robots.ts";
import { kRobotShape, type RobotStyles } from "./robot_styles.ts";
import { ringRadius } from "./robots_canvas.ts";
import { fill, isOnScreen, kSans, stroke, textWidth, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kMostNamed = 60;
const kMostShaped = 1500; // more are drawn as squares
const kLineHeight = 13; // px
const kFont = `500 11px ${kSans}`;

/** @param taken  where names of measures stand */
export function drawStarts(pen: Pen, model: Model, styles: RobotStyles, taken: readonly Box[]): void {
  const settings = model.get("map");
  const starts = model.get("starts");
  if (!settings.layers.robots || starts.count === 0) return;
  const byColor = new Map<string, number[]>();
  for (let row = 0; row < starts.count; ++row) {
    if (!isOnScreen(pen.camera, pen.camera.toScreenX(starts.x(row)), pen.camera.toScreenY(starts.y(row)), 40)) continue;
    const color = styles.cssColor(starts.id(row));
    const rows = byColor.get(color);
    if (rows) rows.push(row);
    else byColor.set(color, [row]);
  }
  for (const [color, rows] of byColor) drawOutlines(pen, starts, styles, rows, color);
  const shown = [...byColor.values()].flat();
  drawSelected(pen, starts, styles, shown);
  if (settings.layers.labels && settings.robotLabels !== "none") drawNames(pen, model, styles, shown, taken);
}

function drawOutlines(pen: Pen, starts: RobotTable, styles: RobotStyles, rows: readonly number[], color: string): void {
  const { context, camera, palette } = pen;
  context.beginPath();
  for (const row of rows) {
    if (rows.length > kMostShaped) {
      context.rect(camera.toScreenX(starts.x(row)) - 1.5, camera.toScreenY(starts.y(row)) - 1.5, 3, 3);
      continue;
    }
    traceArrow(pen, starts, row, styles.pixels(starts.id(row), camera.scale));
  }
  stroke(pen, { color: palette.halo, width: 3.5 });
  fill(pen, palette.halo);
  stroke(pen, { color, width: 1.5 });
  context.beginPath();
  for (const row of rows) {
    const radius = (styles.sizes[starts.id(row) * 2 + 1] ?? 0.2) * camera.scale;
    if (radius < 5) continue;
    const x = camera.toScreenX(starts.x(row));
    const y = camera.toScreenY(starts.y(row));
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  stroke(pen, { color, width: 1, dash: [3, 3] });
}

function traceArrow({ context, camera }: Pen, starts: RobotTable, row: number, length: number): void {
  const x = camera.toScreenX(starts.x(row));
  const y = camera.toScreenY(starts.y(row));
  const c = Math.cos(starts.heading(row)) * length;
  const s = Math.sin(starts.heading(row)) * length;
  kRobotShape.forEach(([ahead, left], i) => {
    if (i === 0) context.moveTo(x + ahead * c - left * s, y - ahead * s - left * c);
    else context.lineTo(x + ahead * c - left * s, y - ahead * s - left * c);
  });
  context.closePath();
}

function drawSelected(pen: Pen, starts: RobotTable, styles: RobotStyles, rows: readonly number[]): void {
  const { context, camera, palette } = pen;
  context.beginPath();
  for (const row of rows) {
    const id = starts.id(row);
    if (!styles.isSelected(id)) continue;
    const radius = ringRadius(styles, id, camera.scale);
    const x = camera.toScreenX(starts.x(row));
    const y = camera.toScreenY(starts.y(row));
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  stroke(pen, { color: palette.halo, width: 4.5 });
  stroke(pen, { color: palette.selection, width: 2.25 });
}

/** What the outlines cover, as long as each can be told from the others. */
export function startBoxes({ camera }: Pen, model: Model, styles: RobotStyles): Box[] {
  const starts = model.get("starts");
  if (!model.get("map").layers.robots || starts.count > kMostNamed) return [];
  return Array.from({ length: starts.count }, (_, row) => {
    const x = camera.toScreenX(starts.x(row));
    const y = camera.toScreenY(starts.y(row));
    const half = styles.pixels(starts.id(row), camera.scale) / 2;
    return { xMin: x - half, xMax: x + half, yMin: y - half * 0.8, yMax: y + half * 0.8 };
  });
}

interface Name {
  readonly text: string;
  readonly color: string;
}

function drawNames(pen: Pen, model: Model, styles: RobotStyles, rows: readonly number[], taken: readonly Box[]): void {
  const { camera, palette } = pen;
  const starts = model.get("starts");
  const screen: Box = { xMin: 2, yMin: 2, xMax: camera.width - 2, yMax: camera.height - 2 };
  const named = rows.length <= kMostNamed ? rows : rows.filter((row) => styles.isSelected(starts.id(row)));
  const known = new TakenBoxes([...taken, ...startBoxes(pen, model, styles)]);
  // Where they stand too close for a name each, one names them all.
  const clusters = clustersOf(
    named.map((row) => ({ row, x: camera.toScreenX(starts.x(row)), y: camera.toScreenY(starts.y(row)) })),
  );
  const wishes = clusters.flatMap((cluster): LabelWish<Name>[] => {
    const ids = cluster.map(({ row }) => starts.id(row));
    const text = ids.length === 1 ? model.get("roster").nameOf(ids[0]!) : `Robots ${idRanges(ids)}`;
    const isSelected = ids.some((id) => styles.isSelected(id));
    const width = textWidth(pen, text, kFont) + 4;
    const side = styles.pixels(ids[0]!, camera.scale) / 2 + width / 2 + 3;
    const xs = cluster.map(({ x }) => x);
    const ys = cluster.map(({ y }) => y);
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    const [above, below] = [Math.min(...ys), Math.max(...ys)];
    const [x, y] = [(left + right) / 2, (above + below) / 2];
    if (!contains(screen, { x, y })) return [];
    const places = [
      ...[0, 6, -6].flatMap((dy) => [
        { x: right + side, y: y + dy },
        { x: left - side, y: y + dy },
      ]),
      { x, y: below + 17 },
      { x, y: above - 17 },
    ];
    const key = { text, color: isSelected ? palette.selection : palette.ink };
    return [{ key, width, height: kLineHeight, weight: isSelected ? 1 : 0, places }];
  });
  for (const { key, middle } of placeLabels(wishes, known, screen))
    writeText(pen, key.text, middle.x, middle.y, key.color, kFont);
}
