// What lies over the robots: objects that have moved, stations, wanted velocities, marks, names, and all of watched robots.
import type { Box } from "../geometry.ts";
import type { Model } from "../model.ts";
import { drawDecorations } from "./decorations.ts";
import { drawObject } from "./ground.ts";
import { drawMarks, drawRobotLabels } from "./robot_marks.ts";
import type { RobotStyles } from "./robot_styles.ts";
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
  if (scene && layers.objects) {
    for (const object of scene.objects) {
      const moved = model.movedObjects.get(object.id);
      if (moved) drawObject(pen, object, moved.x, moved.y);
    }
  }
  if (layers.robots) {
    if (layers.stations) drawStations(pen, model, state.styles);
    if (layers.vectors) drawVectors(pen, model);
    drawWatched(pen, model, state.styles);
    drawMarks(pen, model, state);
    drawRobotLabels(pen, model, state);
  }
  if (layers.decorations) drawDecorations(pen);
}
