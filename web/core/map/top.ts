// What lies over the robots: objects that have moved, stations, wanted velocities, marks, names, and all of watched robots.
import type { Box } from "../geometry.ts";
import type { Model } from "../model.ts";
import { drawObject } from "./ground.ts";
import { drawMoving, hasMoving } from "./moving.ts";
import { drawMarks, drawRobotLabels, hasMarks } from "./robot_marks.ts";
import type { RobotStyles } from "./robot_styles.ts";
import { drawShares, hasShares } from "./shares.ts";
import { drawStations, drawVectors } from "./team.ts";
import type { MapPick, Pen } from "./tool.ts";
import { drawWatched } from "./watched.ts";

export interface TopState {
  readonly hover: MapPick | null;
  /** Where names of measures stand. */
  readonly taken: readonly Box[];
  readonly styles: RobotStyles;
}

export function drawTop(pen: Pen, model: Model, state: TopState): void {
  const { layers } = model.get("map");
  const scene = model.get("scene");
  if (scene && layers.obstacles && hasMoving(model)) drawMoving(pen, scene, model.time);
  if (scene && layers.objects) {
    for (const object of scene.objects) {
      const moved = model.movedObjects.get(object.id);
      if (moved) drawObject(pen, object, moved.x, moved.y);
    }
  }
  if (layers.shares) drawShares(pen, model, state.styles);
  if (layers.robots) {
    if (layers.stations) drawStations(pen, model, state.styles);
    if (layers.vectors) drawVectors(pen, model);
    const names = drawWatched(pen, model, state);
    drawMarks(pen, model, state);
    drawRobotLabels(pen, model, { ...state, taken: [...state.taken, ...names] });
  }
}

/** Whether there is anything to draw: an empty canvas need not be shown. */
export function isTopEmpty(model: Model, { hover }: TopState): boolean {
  const { layers, robotLabels } = model.get("map");
  if (model.movedObjects.size > 0 && layers.objects) return false;
  if (layers.obstacles && hasMoving(model)) return false;
  if (layers.shares && hasShares(model)) return false;
  if (!layers.robots) return true;
  if (hover?.kind === "robot" || model.get("selection").robots.length > 0 || robotLabels === "all") return false;
  if ((layers.stations && model.stations.count > 0) || (layers.vectors && model.vectors.count > 0)) return false;
  return !hasMarks(model.robots);
}
