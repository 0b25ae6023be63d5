// Where the pointer is while control measures are drawn and changed, on the grid where there is one.
import { distance, type Point } from "../../core/geometry.ts";
import { kDragStart } from "../../core/map/input.ts";
import type { MapView } from "../../core/map/map_view.ts";
import type { MapPointer } from "../../core/map/tool.ts";
import { editStore } from "../map_editing/edit_store.ts";
import { snapPoint, toolGrid } from "../map_editing/snap.ts";

export class Aim {
  /** On which it is; nothing: the tool is not taken up. */
  map: MapView | null = null;
  /** Nothing: it is not over the map. */
  over: Point | null = null;
  /** Where the button went down, in the world. */
  downWorld: Point = { x: 0, y: 0 };
  /** The same on the screen; nothing: it is up. */
  private downAt: Point | null = null;

  down(pointer: MapPointer): void {
    this.downAt = pointer.screen;
    this.downWorld = this.snapped(pointer.world);
  }

  lift(): void {
    this.downAt = null;
  }

  get isDown(): boolean {
    return this.downAt !== null;
  }

  /** So far from where the button went down that it was no click. */
  isDragged(pointer: MapPointer): boolean {
    return this.downAt !== null && distance(this.downAt, pointer.screen) > kDragStart;
  }

  /** How near two clicks are the same place [m]. */
  get tolerance(): number {
    return kDragStart / this.scale;
  }

  /** The middle of what is in sight: for who has no pointer. */
  get middle(): Point {
    return this.snapped({ x: this.map?.camera.x ?? 0, y: this.map?.camera.y ?? 0 });
  }

  snapped(point: Point): Point {
    return snapPoint(point, this.grid);
  }

  /** [m]; 0: there is none. */
  get grid(): number {
    return editStore.getState().grid ? toolGrid(this.scale) : 0;
  }

  /** [px] for a metre. */
  get scale(): number {
    return this.map?.camera.scale ?? 1;
  }

  redraw(): void {
    this.map?.redraw();
  }
}
