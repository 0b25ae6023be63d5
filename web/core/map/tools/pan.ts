// Dragging the map with the main button, or one finger.
import type { Point } from "../../geometry.ts";
import type { MapView } from "../map_view.ts";
import type { MapPointer, MapTool } from "../tool.ts";

export class PanTool implements MapTool {
  readonly name = "pan";
  readonly cursor = "grab";
  private map: MapView | null = null;
  private last: Point | null = null;

  start(map: MapView): void {
    this.map = map;
  }

  down(pointer: MapPointer): void {
    this.last = pointer.screen;
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (!isDragging || !this.last) return;
    this.map?.framing.pan(pointer.screen.x - this.last.x, pointer.screen.y - this.last.y);
    this.last = pointer.screen;
  }

  up(): void {
    this.last = null;
  }

  cancel(): void {
    this.last = null;
  }
}
