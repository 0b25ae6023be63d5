// What tools draw over the map: handles to take hold of, and a note beside the pointer.
import type { Point } from "../../core/geometry.ts";
import type { Pen } from "../../core/map/tool.ts";

/** Corners are solid squares, middles of edges (where a point can be put in) small circles. Pixels. */
export function drawHandle({ context, palette }: Pen, at: Point, kind: "corner" | "middle", isActive: boolean): void {
  context.beginPath();
  if (kind === "corner") context.rect(at.x - 4.5, at.y - 4.5, 9, 9);
  else context.arc(at.x, at.y, 3.5, 0, 2 * Math.PI);
  context.fillStyle = isActive ? palette.selection : palette.halo;
  context.strokeStyle = palette.selection;
  context.lineWidth = 1.5;
  context.fill();
  context.stroke();
}

/** Text on a plate, its middle at the point. */
export function drawNote({ context, palette, camera }: Pen, at: Point, text: string): void {
  context.font = "600 12px system-ui, sans-serif";
  const width = context.measureText(text).width + 14;
  const x = Math.min(Math.max(at.x - width / 2, 4), Math.max(camera.width - width - 4, 4));
  const y = Math.max(at.y - 11, 4);
  context.beginPath();
  context.roundRect(x, y, width, 22, 5);
  context.fillStyle = palette.ink;
  context.fill();
  context.fillStyle = palette.halo;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, x + 7, y + 11.5);
  context.textBaseline = "alphabetic";
}
