// Signs beside robots that need attention, and their names.
import { type Box, contains } from "../geometry.ts";
import { type LabelWish, placeLabels, TakenBoxes } from "../labels.ts";
import type { Model } from "../model.ts";
import { Flag, Life, type RobotTable } from "../robots.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { ringRadius } from "./robots_canvas.ts";
import { fill, isOnScreen, kSans, stroke, textWidth, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";
import type { TopState } from "./top.ts";

const kMostMarks = 400;
const kMostLabels = 600;
const kFont = `600 11px ${kSans}`;

const kCalls = Flag.CONTACT | Flag.STUCK | Flag.TELEOPERATED | Flag.LOST;

export function hasMarks(robots: RobotTable): boolean {
  for (let row = 0; row < robots.count; ++row) {
    const flags = robots.flags(row);
    if (flags & kCalls || (flags & 7) === Life.FAULTED) return true;
  }
  return false;
}

export function drawMarks(pen: Pen, model: Model, { hover, styles }: TopState): void {
  const { camera } = pen;
  const { robots } = model;
  let drawn = 0;
  for (let row = 0; row < robots.count && drawn < kMostMarks; ++row) {
    const flags = robots.flags(row);
    const isHovered = hover?.kind === "robot" && hover.id === robots.id(row);
    if (!isHovered && !(flags & kCalls) && (flags & 7) !== Life.FAULTED) continue;
    const x = camera.toScreenX(robots.x(row));
    const y = camera.toScreenY(robots.y(row));
    if (!isOnScreen(camera, x, y)) continue;
    ++drawn;
    drawMark(pen, x, y, flags, styles, robots.id(row), isHovered);
  }
}

function drawMark(
  pen: Pen,
  x: number,
  y: number,
  flags: number,
  styles: RobotStyles,
  id: number,
  isHovered: boolean,
): void {
  const { context, palette, camera } = pen;
  const radius = ringRadius(styles, id, camera.scale);
  if (isHovered && !styles.isSelected(id)) {
    circle(context, x, y, radius);
    stroke(pen, { color: palette.hover, width: 1.5, dash: [4, 3] });
  }
  if (flags & Flag.TELEOPERATED) {
    circle(context, x, y, radius + 3);
    stroke(pen, { color: palette.teleoperation, width: 2, dash: [2, 3.5] });
  }
  if (flags & Flag.CONTACT) drawBurst(pen, x, y, radius + 1);
  const badge =
    (flags & 7) === Life.FAULTED
      ? ["×", palette.contact]
      : flags & Flag.LOST
        ? ["?", palette.warning]
        : flags & Flag.STUCK
          ? ["!", palette.warning]
          : null;
  if (badge) drawBadge(pen, x + radius * 0.8, y - radius * 0.8, badge[0]!, badge[1]!);
}

/** A ring of rays: something was hit. */
function drawBurst(pen: Pen, x: number, y: number, radius: number): void {
  const { context, palette } = pen;
  context.beginPath();
  for (let i = 0; i < 8; ++i) {
    const angle = ((i + 0.5) / 8) * 2 * Math.PI;
    const ux = Math.cos(angle);
    const uy = Math.sin(angle);
    context.moveTo(x + ux * radius, y + uy * radius);
    context.lineTo(x + ux * (radius + 5), y + uy * (radius + 5));
  }
  stroke(pen, { color: palette.contact, width: 2.25 });
}

function drawBadge(pen: Pen, x: number, y: number, sign: string, color: string): void {
  const { context, palette } = pen;
  circle(context, x, y, 6.5);
  fill(pen, color);
  stroke(pen, { color: palette.halo, width: 1.25 });
  context.fillStyle = palette.isDark ? palette.ground : "#ffffff";
  context.font = `800 10.5px ${kSans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(sign, x, y + 0.5);
}

function circle(context: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

export function drawRobotLabels(pen: Pen, model: Model, { hover, taken, styles }: TopState): void {
  const { layers, robotLabels } = model.get("map");
  const ids = layers.labels ? labelled(model, robotLabels, hover?.kind === "robot" ? hover.id : 0) : [];
  if (ids.length === 0) return;
  const { camera, palette } = pen;
  const screen: Box = { xMin: 2, yMin: 2, xMax: camera.width - 2, yMax: camera.height - 2 };
  const wishes = ids.flatMap((id) => wishOf(pen, model, styles, id, screen) ?? []);
  const bodies = wishes.map(({ body }) => body);
  for (const { key, middle } of placeLabels(wishes, new TakenBoxes([...taken, ...bodies]), screen)) {
    writeText(pen, key.text, middle.x, middle.y, key.isSelected ? palette.selection : palette.ink, kFont);
  }
}

function labelled(model: Model, setting: "none" | "selected" | "all", hovered: number): number[] {
  const ids = new Set<number>(hovered ? [hovered] : []);
  if (setting !== "none") for (const id of model.get("selection").robots.slice(0, kMostLabels)) ids.add(id);
  if (setting === "all") {
    const { robots } = model;
    for (let row = 0; row < robots.count && ids.size < kMostLabels; ++row) ids.add(robots.id(row));
  }
  return [...ids];
}

interface RobotKey {
  readonly text: string;
  readonly isSelected: boolean;
}

function wishOf(
  pen: Pen,
  model: Model,
  styles: RobotStyles,
  id: number,
  screen: Box,
): (LabelWish<RobotKey> & { body: Box }) | null {
  const place = model.placeOf(id);
  if (!place) return null;
  const { camera } = pen;
  const { x, y } = camera.toScreen(place);
  if (!contains(screen, { x, y })) return null;
  const text = model.get("roster").nameOf(id);
  const width = textWidth(pen, text, kFont) + 4;
  const radius = ringRadius(styles, id, camera.scale);
  const half = styles.pixels(id, camera.scale) / 2;
  const isSelected = styles.isSelected(id);
  return {
    key: { text, isSelected },
    width,
    height: 14,
    weight: isSelected ? 2 : 1,
    places: [
      { x: x + radius + width / 2 + 1, y },
      { x: x - radius - width / 2 - 1, y },
      { x, y: y + radius + 8 },
      { x, y: y - radius - 8 },
    ],
    body: { xMin: x - half, xMax: x + half, yMin: y - half, yMax: y + half },
  };
}
