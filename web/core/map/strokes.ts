// Paths from world points, in screen pixels.
import type { Camera } from "../camera.ts";
import type { Point } from "../geometry.ts";
import type { Pen } from "./tool.ts";

export const kSans = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", "DejaVu Sans", sans-serif';

export function trace(pen: Pen, points: readonly Point[], isClosed = false): void {
  const { context, camera } = pen;
  context.beginPath();
  points.forEach((point, i) => {
    const x = camera.toScreenX(point.x);
    const y = camera.toScreenY(point.y);
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  if (isClosed) context.closePath();
}

/** @param radius  [m]; drawn with at least `least` pixels */
export function traceCircle(pen: Pen, centre: Point, radius: number, least = 0): void {
  const { context, camera } = pen;
  context.beginPath();
  const pixels = Math.max(least, radius * camera.scale);
  context.arc(camera.toScreenX(centre.x), camera.toScreenY(centre.y), pixels, 0, 2 * Math.PI);
}

export interface Line {
  readonly color: string;
  readonly width?: number;
  readonly dash?: readonly number[];
}

export function stroke(pen: Pen, { color, width = 1.5, dash = [] }: Line): void {
  const { context } = pen;
  context.strokeStyle = color;
  context.lineWidth = width;
  context.lineJoin = "round";
  context.lineCap = dash.length ? "butt" : "round";
  context.setLineDash([...dash]);
  context.stroke();
  context.setLineDash([]);
}

export function fill(pen: Pen, color: string): void {
  pen.context.fillStyle = color;
  pen.context.fill();
}

/** Parallel strokes over the path that was traced last, `gap` pixels apart, rising to the right where `rises`. */
export function hatch(pen: Pen, color: string, gap = 12, rises = true): void {
  const { context, camera } = pen;
  context.save();
  context.clip();
  context.beginPath();
  // The strokes are fixed to the world's origin, so that they don't swim while the map is dragged.
  const reach = camera.width + camera.height;
  const origin = rises
    ? camera.toScreenX(0) + camera.toScreenY(0)
    : camera.toScreenX(0) - camera.toScreenY(0) + camera.height;
  for (let at = (((origin % gap) + gap) % gap) - gap; at < reach; at += gap) {
    if (rises) {
      context.moveTo(at, 0);
      context.lineTo(at - camera.height, camera.height);
    } else {
      context.moveTo(at - camera.height, 0);
      context.lineTo(at, camera.height);
    }
  }
  context.strokeStyle = color;
  context.lineWidth = 1;
  context.stroke();
  context.restore();
}

/** Text that can be read on anything. `x`, `y`: its middle. */
export function writeText(pen: Pen, text: string, x: number, y: number, color: string, font: string): void {
  const { context, palette } = pen;
  context.font = font;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = palette.halo;
  context.globalAlpha = 0.9;
  context.strokeText(text, x, y);
  context.globalAlpha = 1;
  context.fillStyle = color;
  context.fillText(text, x, y);
}

const kWidths = new Map<string, number>();

export function textWidth(pen: Pen, text: string, font: string): number {
  const key = `${font}|${text}`;
  let width = kWidths.get(key);
  if (width === undefined) {
    if (kWidths.size > 5000) kWidths.clear();
    pen.context.font = font;
    width = pen.context.measureText(text).width;
    kWidths.set(key, width);
  }
  return width;
}

/** On whole device pixels: a thin line is sharp there. */
export function crisp(pen: Pen, value: number, width = 1): number {
  const half = Math.round(width * pen.density) % 2 ? 0.5 : 0;
  return (Math.round(value * pen.density - half) + half) / pen.density;
}

/** An arrow from one screen point to another; nothing where they are the same. */
export function arrow(pen: Pen, from: Point, to: Point, { color, width = 1.5, dash = [] }: Line, head = 8): void {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length < 1) return;
  const { context } = pen;
  const ux = (to.x - from.x) / length;
  const uy = (to.y - from.y) / length;
  const size = Math.min(head, length * 0.6);
  const neck = { x: to.x - ux * size * 0.8, y: to.y - uy * size * 0.8 };
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(neck.x, neck.y);
  stroke(pen, { color, width, dash });
  context.beginPath();
  context.moveTo(to.x, to.y);
  context.lineTo(to.x - ux * size - uy * size * 0.5, to.y - uy * size + ux * size * 0.5);
  context.lineTo(to.x - ux * size + uy * size * 0.5, to.y - uy * size - ux * size * 0.5);
  context.closePath();
  fill(pen, color);
}

export function isOnScreen(camera: Camera, x: number, y: number, margin = 20): boolean {
  return x > -margin && y > -margin && x < camera.width + margin && y < camera.height + margin;
}
