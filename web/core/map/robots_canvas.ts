// Robots by Canvas2D paths: the finest look, for up to about a thousand and a half.
import type { Camera } from "../camera.ts";
import type { RobotTable } from "../robots.ts";
import type { Palette } from "./palette.ts";
import { kRobotShape, type RobotStyles } from "./robot_styles.ts";

/** `context` is in CSS pixels and empty. */
export function drawRobotsByPath(
  context: CanvasRenderingContext2D,
  camera: Camera,
  robots: RobotTable,
  styles: RobotStyles,
  palette: Palette,
  circles: boolean,
): void {
  const byColor = new Map<number, number[]>();
  for (let row = 0; row < robots.count; ++row) {
    const x = camera.toScreenX(robots.x(row));
    const y = camera.toScreenY(robots.y(row));
    const reach = styles.pixels(robots.id(row), camera.scale) + 16;
    if (!(x > -reach && y > -reach && x < camera.width + reach && y < camera.height + reach)) continue;
    const at = Math.min(robots.id(row), styles.capacity - 1) * 4;
    const { colors } = styles;
    const key = (colors[at]! << 16) | (colors[at + 1]! << 8) | colors[at + 2]!;
    const rows = byColor.get(key);
    if (rows) rows.push(row);
    else byColor.set(key, [row]);
  }
  for (const [key, rows] of byColor) {
    const color = `#${key.toString(16).padStart(6, "0")}`;
    drawBodies(context, camera, robots, styles, rows, color);
    if (circles) drawCircles(context, camera, robots, styles, rows, color);
    context.beginPath();
    for (const row of rows) traceArrow(context, camera, robots, styles, row);
    context.lineJoin = "round";
    context.strokeStyle = palette.halo;
    context.lineWidth = 2;
    context.stroke();
    context.fillStyle = color;
    context.fill();
  }
  drawSelected(context, camera, robots, styles, palette, [...byColor.values()].flat());
}

function traceArrow(
  context: CanvasRenderingContext2D,
  camera: Camera,
  robots: RobotTable,
  styles: RobotStyles,
  row: number,
): void {
  const x = camera.toScreenX(robots.x(row));
  const y = camera.toScreenY(robots.y(row));
  const length = styles.pixels(robots.id(row), camera.scale);
  const heading = robots.heading(row);
  const c = Math.cos(heading) * length;
  const s = Math.sin(heading) * length;
  for (let i = 0; i < kRobotShape.length; ++i) {
    const [ahead, left] = kRobotShape[i]!;
    const px = x + ahead * c - left * s;
    const py = y - ahead * s - left * c;
    if (i === 0) context.moveTo(px, py);
    else context.lineTo(px, py);
  }
  context.closePath();
}

/** The body's true extent, where it can be told from the arrow. */
function drawBodies(
  context: CanvasRenderingContext2D,
  camera: Camera,
  robots: RobotTable,
  styles: RobotStyles,
  rows: readonly number[],
  color: string,
): void {
  context.beginPath();
  let any = false;
  for (const row of rows) {
    const radius = (styles.sizes[robots.id(row) * 2 + 1] ?? 0.2) * camera.scale;
    if (radius < 5) continue;
    any = true;
    const x = camera.toScreenX(robots.x(row));
    const y = camera.toScreenY(robots.y(row));
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  if (!any) return;
  context.globalAlpha = 0.18;
  context.fillStyle = color;
  context.fill();
  context.globalAlpha = 0.7;
  context.strokeStyle = color;
  context.lineWidth = 1;
  context.stroke();
  context.globalAlpha = 1;
}

function drawCircles(
  context: CanvasRenderingContext2D,
  camera: Camera,
  robots: RobotTable,
  styles: RobotStyles,
  rows: readonly number[],
  color: string,
): void {
  context.beginPath();
  for (const row of rows) {
    const radius = styles.pixels(robots.id(row), camera.scale) * 0.9 + 5;
    const x = camera.toScreenX(robots.x(row));
    const y = camera.toScreenY(robots.y(row));
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.strokeStyle = color;
  context.lineWidth = 1.5;
  context.stroke();
}

function drawSelected(
  context: CanvasRenderingContext2D,
  camera: Camera,
  robots: RobotTable,
  styles: RobotStyles,
  palette: Palette,
  rows: readonly number[],
): void {
  context.beginPath();
  for (const row of rows) {
    const id = robots.id(row);
    if (!styles.isSelected(id)) continue;
    const radius = ringRadius(styles, id, camera.scale);
    const x = camera.toScreenX(robots.x(row));
    const y = camera.toScreenY(robots.y(row));
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.strokeStyle = palette.halo;
  context.lineWidth = 4.5;
  context.stroke();
  context.strokeStyle = palette.selection;
  context.lineWidth = 2.25;
  context.stroke();
}

/** Of the ring round a selected robot [CSS pixels]. */
export function ringRadius(styles: RobotStyles, id: number, scale: number): number {
  return Math.max(styles.pixels(id, scale) * 0.62, (styles.sizes[id * 2 + 1] ?? 0.2) * scale) + 3.5;
}
