// Things of the Scene as the world tools see them, and the changes that bring them about.
import { isMoving } from "../../core/map/moving.ts";
import type { Model } from "../../core/model.ts";
import type { Scene } from "../../core/protocol.ts";
import type { MapChangeInit } from "../map_editing/edit_map.ts";
import type { ObjectStyle, ObjectThing, ObstacleThing, Thing } from "../map_editing/things.ts";

const kStyles: readonly ObjectStyle[] = ["fixed", "movable", "container"];

/** All obstacles, then all objects; objects where they are now, but those with a route where it begins. */
export function thingsOf(scene: Scene | null, moved: Model["movedObjects"]): Thing[] {
  if (!scene) return [];
  const obstacles = scene.obstacles.map(
    (o, index): ObstacleThing => ({
      type: "obstacle",
      index,
      x: o.x,
      y: o.y,
      radius: o.radius,
      height: o.height,
      document: o.document,
    }),
  );
  const objects = scene.objects.map((o, index): ObjectThing => {
    const at = isMoving(o) ? o : (moved.get(o.id) ?? o);
    const style = kStyles[o.style] ?? "fixed";
    const { diameter, color, document } = o;
    return { type: "object", index, x: at.x, y: at.y, diameter, style, color, document };
  });
  return [...obstacles, ...objects];
}

export function replaceThing(thing: Thing): MapChangeInit {
  const { index } = thing;
  return thing.type === "obstacle"
    ? { change: { case: "replaceObstacle", value: { index, obstacle: obstacleOf(thing) } } }
    : { change: { case: "replaceObject", value: { index, object: objectOf(thing) } } };
}

export function addThing(thing: Thing): MapChangeInit {
  return thing.type === "obstacle"
    ? { change: { case: "addObstacle", value: obstacleOf(thing) } }
    : { change: { case: "addObject", value: objectOf(thing) } };
}

/** Where the thing stands in a new Scene: the last one at that place. -1: nowhere. */
export function indexOfThing(scene: Scene, thing: Thing): number {
  const isThere = (o: { x: number; y: number }) => Math.hypot(o.x - thing.x, o.y - thing.y) < 0.02;
  return thing.type === "obstacle"
    ? scene.obstacles.findLastIndex((o) => o.document !== "" && isThere(o))
    : scene.objects.findLastIndex((o) => o.document !== "" && isThere(o));
}

function obstacleOf({ x, y, radius, height }: ObstacleThing) {
  return { x, y, radius, height };
}

function objectOf({ x, y, diameter, style, color }: ObjectThing) {
  return { x, y, diameter, style: kStyles.indexOf(style), color };
}
