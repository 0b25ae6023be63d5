// What stands still: mission area, picture, grid, overlay, obstacles, objects, names.
import { parseColor, readableOn, toHex } from "../color.ts";
import { roundDown } from "../format.ts";
import { overlaps } from "../geometry.ts";
import type { Model } from "../model.ts";
import { type Measure, type Scene, WorldObject_Style } from "../protocol.ts";
import type { MapItem } from "../selection.ts";
import { kindOfWire } from "../tables/measures.ts";
import type { PlacedLabel } from "./measure_labels.ts";
import { boxOfMeasure, shapeOf } from "./measure_shape.ts";
import { drawMilitary } from "./measures_military.ts";
import { drawPlain } from "./measures_plain.ts";
import { drawRoutes, isMoving } from "./moving.ts";
import { fade } from "./palette.ts";
import { crisp, fill, isOnScreen, stroke, trace, traceCircle, writeText } from "./strokes.ts";
import type { MapPick, Pen } from "./tool.ts";

/** What lies below all that the overlay says. */
export interface Below {
  readonly picture: HTMLImageElement | null;
  readonly tiles: { draw(pen: Pen): void } | null;
}

export function drawGround(pen: Pen, model: Model, below: Below, hover: MapPick | null): void {
  const scene = model.get("scene");
  const { layers } = model.get("map");
  drawArea(pen, scene);
  below.tiles?.draw(pen);
  if (!scene) return;
  drawAreaEdge(pen, scene);
  if (layers.picture && below.picture) drawPicture(pen, scene, below.picture);
  if (layers.grid) drawGrid(pen, scene);
  if (layers.measures) drawMeasures(pen, scene);
  if (layers.obstacles) drawObstacles(pen, scene);
  if (layers.objects) {
    drawRoutes(pen, scene.objects);
    for (const object of scene.objects) {
      if (!model.movedObjects.has(object.id)) drawObject(pen, object, object.x, object.y);
    }
  }
  const { items } = model.get("selection");
  for (const item of items) drawChosen(pen, model, scene, item, true);
  if (hover && hover.kind !== "robot") drawChosen(pen, model, scene, hover, false);
}

/** What stands still above the robots, so that many of them don't hide it. */
export function drawNames(pen: Pen, labels: readonly PlacedLabel[]): void {
  for (const { text, middle, color, font } of labels) writeText(pen, text, middle.x, middle.y, color, font);
}

function drawArea(pen: Pen, scene: Scene | null): void {
  const { context, camera, palette } = pen;
  context.fillStyle = scene ? palette.outside : palette.ground;
  context.fillRect(0, 0, camera.width, camera.height);
  if (!scene) return;
  const left = crisp(pen, camera.toScreenX(0));
  const top = crisp(pen, camera.toScreenY(scene.height));
  const right = crisp(pen, camera.toScreenX(scene.width));
  const bottom = crisp(pen, camera.toScreenY(0));
  context.fillStyle = palette.ground;
  context.fillRect(left, top, right - left, bottom - top);
}

function drawAreaEdge(pen: Pen, scene: Scene): void {
  const { context, camera, palette } = pen;
  const left = crisp(pen, camera.toScreenX(0));
  const top = crisp(pen, camera.toScreenY(scene.height));
  context.beginPath();
  context.rect(left, top, crisp(pen, camera.toScreenX(scene.width)) - left, crisp(pen, camera.toScreenY(0)) - top);
  stroke(pen, { color: palette.areaEdge, width: 1 });
}

function drawPicture(pen: Pen, scene: Scene, picture: HTMLImageElement): void {
  const { context, camera, palette } = pen;
  const place = scene.picture;
  if (!place) return;
  context.globalAlpha = palette.isDark ? 0.6 : 0.85;
  const x = camera.toScreenX(place.x);
  const y = camera.toScreenY(place.y + place.height);
  context.drawImage(picture, x, y, place.width * camera.scale, place.height * camera.scale);
  context.globalAlpha = 1;
}

/** The step between grid lines [m]: the least round number that leaves them room. */
export function gridStep(scale: number): number {
  return roundDown(110 / scale);
}

function drawGrid(pen: Pen, scene: Scene): void {
  const { context, camera, palette } = pen;
  const step = gridStep(camera.scale);
  const seen = camera.visible();
  const x0 = Math.max(0, seen.xMin);
  const x1 = Math.min(scene.width, seen.xMax);
  const y0 = Math.max(0, seen.yMin);
  const y1 = Math.min(scene.height, seen.yMax);
  if (x0 >= x1 || y0 >= y1) return;
  for (const strong of [false, true]) {
    context.beginPath();
    for (let i = Math.ceil(x0 / step); i * step <= x1; ++i) {
      if ((i % 5 === 0) !== strong) continue;
      const x = crisp(pen, camera.toScreenX(i * step));
      context.moveTo(x, camera.toScreenY(y0));
      context.lineTo(x, camera.toScreenY(y1));
    }
    for (let i = Math.ceil(y0 / step); i * step <= y1; ++i) {
      if ((i % 5 === 0) !== strong) continue;
      const y = crisp(pen, camera.toScreenY(i * step));
      context.moveTo(camera.toScreenX(x0), y);
      context.lineTo(camera.toScreenX(x1), y);
    }
    stroke(pen, { color: strong ? palette.gridStrong : palette.grid, width: 1 });
  }
}

function drawMeasures(pen: Pen, scene: Scene): void {
  const seen = pen.camera.visible();
  const inOrder = scene.measures
    .filter((measure) => isNear(measure, seen, 60 / pen.camera.scale))
    .sort((a, b) => layerOf(a) - layerOf(b));
  for (const measure of inOrder) {
    if (pen.military) drawMilitary(pen, measure);
    else drawPlain(pen, measure);
  }
}

/** What is drawn first lies below. */
function layerOf(measure: Measure): number {
  return kindOfWire(measure.kind)?.layer ?? 0;
}

function isNear(measure: Measure, seen: Parameters<typeof overlaps>[0], margin: number): boolean {
  const box = boxOfMeasure(measure);
  if (!box) return false;
  const { xMin, yMin, xMax, yMax } = box;
  return overlaps({ xMin: xMin - margin, yMin: yMin - margin, xMax: xMax + margin, yMax: yMax + margin }, seen);
}

function drawObstacles(pen: Pen, scene: Scene): void {
  const { context, camera, palette } = pen;
  const color = pen.military ? palette.militaryObstacle : palette.obstacle;
  context.beginPath();
  for (const obstacle of scene.obstacles) {
    if (isMoving(obstacle)) continue; // drawn where it is now, over the robots
    const { x, y, radius } = obstacle;
    const pixels = Math.max(1, radius * camera.scale);
    const sx = camera.toScreenX(x);
    const sy = camera.toScreenY(y);
    if (!isOnScreen(camera, sx, sy, pixels)) continue;
    context.moveTo(sx + pixels, sy);
    context.arc(sx, sy, pixels, 0, 2 * Math.PI);
  }
  fill(pen, color);
  if (scene.obstacles.length < 3000) stroke(pen, { color: palette.obstacleEdge, width: 1 });
  drawRoutes(pen, scene.obstacles);
}

/** One object at its place now. Containers have a rim, fixed ones are squares with round corners. */
export function drawObject(pen: Pen, object: Scene["objects"][number], x: number, y: number): void {
  const { context, camera, palette } = pen;
  const sx = camera.toScreenX(x);
  const sy = camera.toScreenY(y);
  const radius = Math.max(3, (object.diameter / 2) * camera.scale);
  if (!isOnScreen(camera, sx, sy, radius)) return;
  const color = toHex(readableOn(parseColor(object.color) ?? parseColor(palette.softInk)!, palette.groundRgb, 1.9));
  context.beginPath();
  context.arc(sx, sy, radius, 0, 2 * Math.PI);
  if (object.style === WorldObject_Style.CONTAINER) {
    fill(pen, fade(color, 0.25));
    stroke(pen, { color, width: Math.max(2, radius * 0.18) });
    if (radius > 5) {
      context.beginPath();
      context.arc(sx, sy, radius * 0.55, 0, 2 * Math.PI);
      stroke(pen, { color, width: 1, dash: [3, 2] });
    }
    return;
  }
  fill(pen, color);
  if (object.style === WorldObject_Style.MOVABLE) stroke(pen, { color: palette.halo, width: 1.5 });
  else stroke(pen, { color: fade(palette.ink, 0.5), width: 1 });
}

function drawChosen(pen: Pen, model: Model, scene: Scene, item: MapItem, isSelected: boolean): void {
  const { palette } = pen;
  const draw = (): void => {
    stroke(pen, { color: fade(palette.selection, isSelected ? 0.28 : 0.18), width: isSelected ? 8 : 6 });
    if (isSelected) stroke(pen, { color: palette.selection, width: 2 });
  };
  if (item.kind === "obstacle") {
    const obstacle = scene.obstacles[item.index];
    if (!obstacle) return;
    traceCircle(pen, obstacle, obstacle.radius, 3);
    draw();
    return;
  }
  if (item.kind === "object") {
    const object = scene.objects[item.index];
    if (!object) return;
    const moved = isMoving(object) ? null : model.movedObjects.get(object.id);
    traceCircle(pen, moved ?? object, object.diameter / 2, 5);
    draw();
    return;
  }
  const measure = item.kind === "measure" ? scene.measures[item.index] : undefined;
  const shape = measure && shapeOf(measure);
  if (!shape) return;
  if (shape.kind === "circle") traceCircle(pen, shape.centre, shape.radius, 4);
  else if (shape.kind === "point") traceCircle(pen, shape.at, 0, 10);
  else trace(pen, shape.points, shape.kind === "polygon");
  draw();
}
