// What robots share among themselves, while they do: places to visit, pieces of an area to search, and the round of a
// patrol, of which each has what is before it.
import type { Point } from "../geometry.ts";
import type { Model } from "../model.ts";
import { type Status_Command_Part, Status_Outcome } from "../protocol.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { fill, isOnScreen, kSans, stroke, textWidth, writeText } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kMostNamed = 40; // parts: of more, names would be a tangle
const kNameFont = `600 10.5px ${kSans}`;
const kBadge = 6.5; // px

interface Shares {
  readonly parts: readonly Status_Command_Part[];
  /** [m]; 0: they are places */
  readonly swath: number;
}

function sharesOf(model: Model): Shares[] {
  return (model.get("status")?.steps ?? [])
    .flatMap(({ commands }) => commands)
    .filter(({ outcome, shared }) => outcome === Status_Outcome.UNDER_WAY && shared.length > 0)
    .map(({ shared, swath }) => ({ parts: shared, swath }));
}

export function hasShares(model: Model): boolean {
  return sharesOf(model).length > 0;
}

/** Who has what is in his colour, with his name; what is done is filled; what nobody has is grey. */
export function drawShares(pen: Pen, model: Model, styles: RobotStyles): void {
  for (const { parts, swath } of sharesOf(model)) {
    for (const part of parts) {
      const color = part.robot === 0 ? pen.palette.softInk : styles.cssColor(part.robot);
      if (part.way.length > 2) drawPiece(pen, part, color, swath);
      else drawPlace(pen, part, color);
    }
    const held = parts.filter(({ robot, isDone }) => robot !== 0 && !isDone);
    const named = held.filter(({ robot }) => !isNamed(model, robot, styles));
    if (named.length <= kMostNamed) for (const part of named) nameHolder(pen, model, part, swath, styles);
  }
}

function drawPiece(pen: Pen, { way, isDone }: Status_Command_Part, color: string, swath: number): void {
  const { context, camera } = pen;
  context.beginPath();
  for (let i = 0; i + 1 < way.length; i += 2) {
    const x = camera.toScreenX(way[i]!);
    const y = camera.toScreenY(way[i + 1]!);
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  if (isDone) {
    context.globalAlpha = 0.2;
    context.lineCap = "butt"; // as far as it was gone, and no farther
    context.lineJoin = "round";
    context.lineWidth = Math.max(4, swath * camera.scale);
    context.strokeStyle = color;
    context.stroke();
    context.globalAlpha = 1;
  } else stroke(pen, { color, width: 1.5, dash: [2, 4] });
}

/** The badge stands beside the place: below it is its name, above it its sign. */
function badgeOf(pen: Pen, way: readonly number[]): Point {
  return { x: pen.camera.toScreenX(way[0]!) + 13, y: pen.camera.toScreenY(way[1]!) };
}

function drawPlace(pen: Pen, { way, isDone }: Status_Command_Part, color: string): void {
  const { context, camera, palette } = pen;
  const { x, y } = badgeOf(pen, way);
  if (!isOnScreen(camera, x, y)) return;
  context.beginPath();
  context.arc(camera.toScreenX(way[0]!), y, 2.5, 0, 2 * Math.PI);
  stroke(pen, { color: palette.halo, width: 2 });
  fill(pen, color);
  context.beginPath();
  context.arc(x, y, kBadge, 0, 2 * Math.PI);
  stroke(pen, { color: palette.halo, width: 4 });
  fill(pen, isDone ? color : palette.ground);
  stroke(pen, { color, width: 1.75, dash: isDone ? [] : [2.5, 2.5] });
  if (!isDone) return;
  context.beginPath();
  context.moveTo(x - 3, y);
  context.lineTo(x - 0.75, y + 2.5);
  context.lineTo(x + 3.25, y - 2.5);
  stroke(pen, { color: palette.ground, width: 1.75 });
}

/** Where it stands. */
function isNamed(model: Model, robot: number, styles: RobotStyles): boolean {
  const { layers, robotLabels } = model.get("map");
  return layers.robots && (robotLabels === "all" || (robotLabels === "selected" && styles.isSelected(robot)));
}

/** Where the piece begins, in the middle of what one has of a round, or beside the place. */
function nameHolder(pen: Pen, model: Model, part: Status_Command_Part, swath: number, styles: RobotStyles): void {
  const { robot, way } = part;
  const name = model.get("roster").nameOf(robot);
  const at = way.length > 2 ? pieceNameAt(pen, way, swath) : placeNameAt(pen, way, name);
  if (isOnScreen(pen.camera, at.x, at.y)) writeText(pen, name, at.x, at.y, styles.cssColor(robot), kNameFont);
}

function placeNameAt(pen: Pen, way: readonly number[], name: string): Point {
  const badge = badgeOf(pen, way);
  return { x: badge.x + kBadge + 4 + textWidth(pen, name, kNameFont) / 2, y: badge.y };
}

function pieceNameAt({ camera }: Pen, way: readonly number[], swath: number): Point {
  const { x, y } = swath > 0 ? { x: way[0]!, y: way[1]! } : middleOf(way);
  return { x: camera.toScreenX(x), y: camera.toScreenY(y) + 9 };
}

/** Half the way along it. */
export function middleOf(way: readonly number[]): Point {
  const lengths: number[] = [];
  for (let i = 2; i + 1 < way.length; i += 2)
    lengths.push(Math.hypot(way[i]! - way[i - 2]!, way[i + 1]! - way[i - 1]!));
  let left = lengths.reduce((sum, length) => sum + length, 0) / 2;
  for (const [i, length] of lengths.entries()) {
    if (left <= length && length > 0) {
      const share = left / length;
      return {
        x: way[2 * i]! + share * (way[2 * i + 2]! - way[2 * i]!),
        y: way[2 * i + 1]! + share * (way[2 * i + 3]! - way[2 * i + 1]!),
      };
    }
    left -= length;
  }
  return { x: way.at(-2) ?? 0, y: way.at(-1) ?? 0 };
}
