// What moves along a route: where obstacles are at a time of the run, as the server computes it (where objects are comes
// with the frames), and the routes.
import { distance, type Point } from "../geometry.ts";
import type { Model } from "../model.ts";
import type { Obstacle, Scene } from "../protocol.ts";
import { fill, isOnScreen, stroke } from "./strokes.ts";
import type { Pen } from "./tool.ts";

export function isMoving(thing: { readonly route: readonly unknown[] }): boolean {
  return thing.route.length > 0;
}

/** Where it is: there and back along its route, round and round where that ends where it begins. */
export function placeAt(obstacle: Obstacle, time: number): Point {
  const points: readonly Point[] = [obstacle, ...obstacle.route];
  const legs = points.slice(1).map((to, i) => distance(points[i]!, to));
  const whole = legs.reduce((sum, leg) => sum + leg, 0);
  if (!(whole > 0)) return { x: obstacle.x, y: obstacle.y };
  const last = points.at(-1)!;
  const isClosed = last.x === obstacle.x && last.y === obstacle.y;
  let along = (obstacle.speed * Math.max(time, 0)) % (isClosed ? whole : 2 * whole);
  if (along > whole) along = 2 * whole - along;
  for (let i = 0; i < legs.length; ++i) {
    const leg = legs[i]!;
    if (along > leg || leg === 0) {
      along -= leg;
      continue;
    }
    const from = points[i]!;
    const to = points[i + 1]!;
    return { x: from.x + ((to.x - from.x) * along) / leg, y: from.y + ((to.y - from.y) * along) / leg };
  }
  return { x: last.x, y: last.y };
}

/** Thin, with a ring where each is at the start: that is where it is taken hold of. */
export function drawRoutes(pen: Pen, things: readonly (Scene["obstacles"][number] | Scene["objects"][number])[]): void {
  const { context, camera, palette } = pen;
  context.beginPath();
  for (const thing of things) {
    if (!isMoving(thing)) continue;
    context.moveTo(camera.toScreenX(thing.x), camera.toScreenY(thing.y));
    for (const { x, y } of thing.route) context.lineTo(camera.toScreenX(x), camera.toScreenY(y));
    addCircle(pen, thing, "radius" in thing ? thing.radius : thing.diameter / 2);
  }
  stroke(pen, { color: palette.obstacleEdge, width: 1, dash: [4, 4] });
}

/** Where they are now. */
export function drawMoving(pen: Pen, scene: Scene, time: number): void {
  const { context, palette } = pen;
  context.beginPath();
  for (const obstacle of scene.obstacles) {
    if (isMoving(obstacle)) addCircle(pen, placeAt(obstacle, time), obstacle.radius);
  }
  fill(pen, pen.military ? palette.militaryObstacle : palette.obstacle);
  stroke(pen, { color: palette.obstacleEdge, width: 1 });
}

export function hasMoving(model: Model): boolean {
  return model.get("scene")?.obstacles.some(isMoving) ?? false;
}

function addCircle({ context, camera }: Pen, { x, y }: Point, radius: number): void {
  const pixels = Math.max(1, radius * camera.scale);
  const sx = camera.toScreenX(x);
  const sy = camera.toScreenY(y);
  if (!isOnScreen(camera, sx, sy, pixels)) return;
  context.moveTo(sx + pixels, sy);
  context.arc(sx, sy, pixels, 0, 2 * Math.PI);
}
