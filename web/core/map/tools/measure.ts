// Measuring: clicks set points; the tool tells each leg's length and bearing, and the whole.
import { formatBearing, formatDistance } from "../../format.ts";
import { between, distance, lengthOf, type Point } from "../../geometry.ts";
import type { MapView } from "../map_view.ts";
import { fill, kSans, stroke, trace, writeText } from "../strokes.ts";
import type { MapPointer, MapTool, Pen } from "../tool.ts";

export class MeasureTool implements MapTool {
  readonly name = "measure";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private points: Point[] = [];
  private pointer: Point | null = null;

  start(map: MapView): void {
    this.map = map;
  }

  end(): void {
    this.points = [];
    this.pointer = null;
    this.map?.redraw();
  }

  down(pointer: MapPointer): void {
    this.points = [...this.points, pointer.world];
    this.pointer = pointer.world;
    this.map?.redraw();
  }

  move(pointer: MapPointer): void {
    this.pointer = pointer.world;
    this.map?.redraw();
  }

  /** The next click begins anew. */
  doubleClick(): void {
    this.points = [];
    this.map?.redraw();
  }

  leave(): void {
    this.pointer = null;
    this.map?.redraw();
  }

  key(event: KeyboardEvent): boolean {
    if (event.key === "Backspace" || event.key === "Delete") {
      this.points = this.points.slice(0, -1);
    } else if (event.key === "Escape" && this.points.length > 0) {
      this.points = [];
    } else {
      return false;
    }
    this.map?.redraw();
    return true;
  }

  draw(pen: Pen): void {
    const line = this.pointer ? [...this.points, this.pointer] : this.points;
    if (this.points.length === 0) return;
    const { context, camera, palette } = pen;
    trace(pen, line);
    stroke(pen, { color: palette.halo, width: 4 });
    trace(pen, line);
    stroke(pen, { color: palette.selection, width: 2 });
    for (const point of line) {
      const { x, y } = camera.toScreen(point);
      context.beginPath();
      context.arc(x, y, 3.5, 0, 2 * Math.PI);
      fill(pen, palette.ground);
      stroke(pen, { color: palette.selection, width: 2 });
    }
    const font = `600 11.5px ${kSans}`;
    for (let i = 1; i < line.length; ++i) {
      const [a, b] = [line[i - 1]!, line[i]!];
      if (distance(a, b) * camera.scale < 40) continue;
      const middle = camera.toScreen(between(a, b, 0.5));
      const bearing = formatBearing(Math.atan2(b.y - a.y, b.x - a.x));
      const text = `${formatDistance(distance(a, b))} · ${bearing}`;
      writeText(pen, text, middle.x, middle.y - 11, palette.selection, font);
    }
    if (line.length > 2) {
      const { x, y } = camera.toScreen(line.at(-1)!);
      writeText(pen, `Σ ${formatDistance(lengthOf(line))}`, x, y + 16, palette.ink, `700 12px ${kSans}`);
    }
  }
}
