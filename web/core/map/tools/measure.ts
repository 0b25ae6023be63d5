// Measuring: clicks set points (or Enter, in the map's middle); the tool tells each leg's length and bearing, and the
// whole. A double click ends the line; the next click begins anew.
import { formatBearing, formatDistance } from "../../format.ts";
import { distance, lengthOf, type Point, pointBetween } from "../../geometry.ts";
import type { MapView } from "../map_view.ts";
import { fill, kSans, stroke, trace, writeText } from "../strokes.ts";
import type { MapPointer, MapTool, Pen } from "../tool.ts";

export class MeasureTool implements MapTool {
  readonly name = "measure";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private points: readonly Point[] = [];
  private pointer: Point | null = null;
  private isDone = false;

  /** `changed` is told the points that are set, after each change. */
  constructor(private readonly changed: (points: readonly Point[]) => void = () => {}) {}

  start(map: MapView): void {
    this.map = map;
    this.set([]);
  }

  end(): void {
    this.pointer = null;
    this.set([]);
  }

  down(pointer: MapPointer): void {
    this.pointer = pointer.world;
    this.set(this.isDone ? [pointer.world] : [...this.points, pointer.world]);
  }

  move(pointer: MapPointer): void {
    this.pointer = this.isDone ? null : pointer.world;
    this.map?.redraw();
  }

  /** Its first click has set the last point, its second the same once more. */
  doubleClick(): void {
    this.pointer = null;
    this.set(this.points.slice(0, -1));
    this.isDone = this.points.length > 1;
  }

  leave(): void {
    this.pointer = null;
    this.map?.redraw();
  }

  key(event: KeyboardEvent): boolean {
    if (event.key === "Backspace" || event.key === "Delete") {
      this.set(this.points.slice(0, -1));
    } else if (event.key === "Escape" && this.points.length > 0) {
      this.set([]);
    } else if (event.key === "Enter" && this.map) {
      const { camera } = this.map;
      const middle = camera.toWorld({ x: camera.width / 2, y: camera.height / 2 });
      this.set(this.isDone ? [middle] : [...this.points, middle]);
    } else {
      return false;
    }
    return true;
  }

  private set(points: readonly Point[]): void {
    this.points = points;
    this.isDone = false;
    this.changed(points);
    this.map?.redraw();
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
      const middle = camera.toScreen(pointBetween(a, b, 0.5));
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
