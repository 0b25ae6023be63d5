// The movement field on the map: an arrow at each place of the grid, the longer the stronger.
import { fade } from "../../core/map/palette.ts";
import { isOnScreen } from "../../core/map/strokes.ts";
import type { Pen } from "../../core/map/tool.ts";
import { arrowLength } from "../run/field_arrows.ts";
import type { Field } from "../run/live_state.ts";

const kHead = 0.35; // of an arrow's length

export function drawField(pen: Pen, { arrows, pitch }: Field): void {
  const { context, camera, palette } = pen;
  const room = pitch * camera.scale;
  context.beginPath();
  for (const { at, way } of arrows) {
    const { x, y } = camera.toScreen(at);
    if (!isOnScreen(camera, x, y, room)) continue;
    const strength = Math.hypot(way.x, way.y);
    const length = arrowLength(strength, room);
    if (length < 2) {
      context.moveTo(x + 1, y);
      context.arc(x, y, 1, 0, 2 * Math.PI);
      continue;
    }
    const [ux, uy] = [way.x / strength, -way.y / strength];
    const [tipX, tipY] = [x + (ux * length) / 2, y + (uy * length) / 2];
    const head = Math.min(6, length * kHead);
    context.moveTo(x - (ux * length) / 2, y - (uy * length) / 2);
    context.lineTo(tipX, tipY);
    context.moveTo(tipX - (ux + uy * 0.6) * head, tipY - (uy - ux * 0.6) * head);
    context.lineTo(tipX, tipY);
    context.lineTo(tipX - (ux - uy * 0.6) * head, tipY - (uy + ux * 0.6) * head);
  }
  context.strokeStyle = fade(palette.selection, 0.75);
  context.lineWidth = 1.25;
  context.lineJoin = "round";
  context.stroke();
}
