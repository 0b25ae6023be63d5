// A control measure's bare geometry over the map, while it is drawn or changed.
import { fade } from "../../core/map/palette.ts";
import type { Pen } from "../../core/map/tool.ts";
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";
import { hallwayPoints } from "./draft.ts";
import { type Geometry, isClosed } from "./vertices.ts";

export function drawGeometry(pen: Pen, kind: MeasureKind, geometry: Geometry, look: "draft" | "outline"): void {
  const { context, camera, palette } = pen;
  const info = kindInfo(kind);
  const size = geometry.size > 0 ? geometry.size : info.defaultSize;
  const points = geometry.points.map((p) => camera.toScreen(p));
  context.strokeStyle = palette.selection;
  context.fillStyle = fade(palette.selection, 0.14);
  context.lineWidth = 2;
  context.lineJoin = "round";
  context.setLineDash(look === "draft" ? [] : [5, 4]);
  context.beginPath();
  const [first] = points;
  if (points.length === 1 && first) {
    if (info.sizeLabel === "diameter") context.arc(first.x, first.y, (size / 2) * camera.scale, 0, 2 * Math.PI);
  } else if (kind === "hallway") {
    trace(
      context,
      hallwayPoints(geometry.points, size).points.map((p) => camera.toScreen(p)),
      true,
    );
  } else trace(context, points, isClosed(kind, points.length));
  if (info.shape === "region" || info.shape === "point" || kind === "hallway") context.fill();
  if (look === "draft" && info.sizeLabel === "width" && kind !== "hallway" && points.length >= 2) {
    context.save();
    context.strokeStyle = fade(palette.selection, 0.16);
    context.lineWidth = Math.max(size * camera.scale, 2);
    context.setLineDash([]);
    context.stroke();
    context.restore();
  }
  context.stroke();
  context.setLineDash([]);
}

function trace(context: CanvasRenderingContext2D, points: readonly { x: number; y: number }[], closed: boolean): void {
  points.forEach((p, i) => {
    if (i === 0) context.moveTo(p.x, p.y);
    else context.lineTo(p.x, p.y);
  });
  if (closed) context.closePath();
}
