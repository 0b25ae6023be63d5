// What can be shown of all robots at once: where formations want them, and what velocity they want.
import type { Model } from "../model.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { fill, isOnScreen, stroke } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kLookAhead = 4; // s: a velocity is drawn as the way of so long
const kLongest = 60; // px

/** A small cross at each station, and a line to it from its robot. */
export function drawStations(pen: Pen, model: Model, styles: RobotStyles): void {
  const { context, camera, palette } = pen;
  const { stations, robots } = model;
  context.beginPath();
  for (let row = 0; row < stations.count; ++row) {
    const own = robots.rowOf(stations.id(row));
    if (own < 0) continue;
    const x = camera.toScreenX(stations.x(row));
    const y = camera.toScreenY(stations.y(row));
    const rx = camera.toScreenX(robots.x(own));
    const ry = camera.toScreenY(robots.y(own));
    const away = Math.hypot(x - rx, y - ry);
    const body = styles.pixels(stations.id(row), camera.scale) / 2;
    if (away < body || !isOnScreen(camera, x, y, 400)) continue;
    context.moveTo(rx + ((x - rx) * body) / away, ry + ((y - ry) * body) / away);
    context.lineTo(x, y);
  }
  stroke(pen, { color: palette.station, width: 1, dash: [3, 3] });
  context.beginPath();
  for (let row = 0; row < stations.count; ++row) {
    const x = camera.toScreenX(stations.x(row));
    const y = camera.toScreenY(stations.y(row));
    if (!isOnScreen(camera, x, y)) continue;
    context.moveTo(x - 4, y);
    context.lineTo(x + 4, y);
    context.moveTo(x, y - 4);
    context.lineTo(x, y + 4);
  }
  stroke(pen, { color: palette.station, width: 1.75 });
}

/** All in one path: thousands are one stroke. */
export function drawVectors(pen: Pen, model: Model): void {
  const { context, camera, palette } = pen;
  const { vectors, robots } = model;
  const heads: number[] = [];
  const isSummed = model.get("map").contributions; // the sum of watched robots is drawn with its parts
  context.beginPath();
  for (let row = 0; row < vectors.count; ++row) {
    const own = robots.rowOf(vectors.id(row));
    if (own < 0 || (isSummed && model.detail(vectors.id(row))?.contributions.length)) continue;
    const x = camera.toScreenX(robots.x(own));
    const y = camera.toScreenY(robots.y(own));
    if (!isOnScreen(camera, x, y, kLongest)) continue;
    const speed = Math.hypot(vectors.x(row), vectors.y(row));
    if (!(speed > 1e-3)) continue;
    // Long enough to be seen beyond the robot, whatever the scale.
    const length = Math.min(kLongest, Math.max(18, speed * kLookAhead * camera.scale));
    const dx = (vectors.x(row) / speed) * length;
    const dy = (-vectors.y(row) / speed) * length;
    context.moveTo(x, y);
    context.lineTo(x + dx, y + dy);
    heads.push(x + dx, y + dy, dx / length, dy / length);
  }
  stroke(pen, { color: palette.ink, width: 1.25 });
  context.beginPath();
  for (let i = 0; i < heads.length; i += 4) {
    const [x, y, ux, uy] = [heads[i]!, heads[i + 1]!, heads[i + 2]!, heads[i + 3]!];
    context.moveTo(x + ux * 2, y + uy * 2);
    context.lineTo(x - ux * 5 - uy * 3, y - uy * 5 + ux * 3);
    context.lineTo(x - ux * 5 + uy * 3, y - uy * 5 - ux * 3);
    context.closePath();
  }
  fill(pen, palette.ink);
}
