// Changing a control measure that stands: moved as a whole, by its handles, or by keys.
import { centreOf, distance, type Point } from "../../core/geometry.ts";
import { fade } from "../../core/map/palette.ts";
import type { MapPointer, Pen } from "../../core/map/tool.ts";
import { kNothing, selectItem } from "../../core/selection.ts";
import { editMap, removeItems } from "../map_editing/edit_map.ts";
import { drawHandle, drawNote } from "../map_editing/handles.ts";
import { nudgeOf, snapNumber } from "../map_editing/snap.ts";
import type { Session } from "../session/session.ts";
import type { Aim } from "./aim.ts";
import {
  type EditedMeasure,
  editedMeasure,
  geometryOf,
  replaceMeasure,
  titleOf,
  withGeometry,
} from "./scene_measures.ts";
import { drawGeometry } from "./sketch.ts";
import { dragHandle, type Geometry, type Handle, handlesOf, moveAll, removeCorner } from "./vertices.ts";

/** What the hand has of a measure. */
interface Grip {
  readonly index: number;
  readonly measure: EditedMeasure;
  readonly handle: Handle;
}

interface Drag extends Grip {
  readonly from: Point;
  now: Geometry;
  isMoved: boolean;
}

const kReach = 9; // px
const kTouchReach = 20;

export class Reshaping {
  private drag: Drag | null = null;
  /** Its corner that keys move and remove. */
  private corner = -1;

  constructor(
    private readonly session: Session,
    private readonly aim: Aim,
  ) {}

  down(pointer: MapPointer): void {
    const reach = pointer.isTouch ? kTouchReach : kReach;
    const grip = this.gripAt(pointer.screen, reach) ?? this.pick(pointer);
    if (!grip) {
      this.session.model.select(kNothing);
      return;
    }
    this.corner = grip.handle.type === "corner" ? grip.handle.index : -1;
    this.drag = { ...grip, from: pointer.world, now: geometryOf(grip.measure), isMoved: false };
    this.aim.redraw();
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (this.drag && isDragging) {
      this.drag.isMoved ||= this.aim.isDragged(pointer);
      if (this.drag.isMoved) this.drag.now = this.dragged(this.drag, pointer.world);
    } else this.showCursor(pointer);
  }

  up(): void {
    const { drag } = this;
    this.drag = null;
    if (!drag?.isMoved) return;
    this.replace(drag.index, drag.measure, drag.now, drag.handle.type === "whole" ? "move" : "change");
  }

  doubleClick(pointer: MapPointer): void {
    const grip = this.gripAt(pointer.screen, kReach);
    if (grip?.handle.type === "corner") this.removeCornerOf(grip.index, grip.measure, grip.handle.index);
  }

  /** What was dragged is where it was. */
  letGo(): void {
    this.drag = null;
  }

  key(event: KeyboardEvent): boolean {
    const chosen = this.selected();
    if (!chosen) return false;
    const { index, measure } = chosen;
    if (event.key === "Delete" || event.key === "Backspace") {
      if (this.corner >= 0 && this.removeCornerOf(index, measure, this.corner)) return true;
      void removeItems(this.session, [{ kind: "measure", index }]);
      return true;
    }
    const step = nudgeOf(event.key, event.shiftKey, this.aim.grid, 1 / this.aim.scale);
    if (!step) return false;
    const before = geometryOf(measure);
    const at = before.points[this.corner];
    const now = at
      ? dragHandle(before, { type: "corner", index: this.corner }, at, { x: at.x + step.dx, y: at.y + step.dy })
      : moveAll(before, step.dx, step.dy);
    this.replace(index, measure, now, at ? "change" : "move");
    return true;
  }

  private replace(index: number, measure: EditedMeasure, geometry: Geometry, verb: string): void {
    const change = replaceMeasure(index, withGeometry(measure, geometry));
    void editMap(this.session, `${verb} ${titleOf(measure)}`, [change]);
  }

  private removeCornerOf(index: number, measure: EditedMeasure, corner: number): boolean {
    const now = measure.kind === "hallway" ? null : removeCorner(measure.kind, geometryOf(measure), corner);
    if (!now) return false;
    this.corner = -1;
    void editMap(this.session, `remove a point of ${titleOf(measure)}`, [
      replaceMeasure(index, withGeometry(measure, now)),
    ]);
    return true;
  }

  forgetCorner(): void {
    this.corner = -1;
    this.aim.redraw();
  }

  private gripAt(screen: Point, reach: number): Grip | null {
    const chosen = this.selected();
    if (!chosen || !this.aim.map) return null;
    const { index, measure } = chosen;
    const { points, size } = geometryOf(measure);
    let best: Handle | null = null;
    let least = reach;
    for (const placed of handlesOf(measure.kind, points, size)) {
      const away = distance(this.aim.map.camera.toScreen(placed), screen);
      if (away > least) continue;
      least = away;
      best = placed.handle;
    }
    return best ? { index, measure, handle: best } : null;
  }

  private pick(pointer: MapPointer): Grip | null {
    const found = pointer.picks().find((pick) => pick.kind === "measure");
    if (found?.kind !== "measure") return null;
    const { model, ui } = this.session;
    if (!isSelected(model.get("selection").items, found.index)) model.select(selectItem(found));
    const wire = model.get("scene")?.measures[found.index];
    const measure = wire && editedMeasure(wire);
    if (!measure) return null;
    if (wire.document === "") {
      ui.tell("This is no part of an overlay: change it in the mission’s text.", "hold");
      return null;
    }
    return { index: found.index, measure, handle: { type: "whole" } };
  }

  /** The one selected measure, if it can be changed. */
  private selected(): { index: number; measure: EditedMeasure } | null {
    const { model } = this.session;
    const [item, ...others] = model.get("selection").items;
    if (item?.kind !== "measure" || others.length > 0) return null;
    const wire = model.get("scene")?.measures[item.index];
    const measure = wire && wire.document !== "" ? editedMeasure(wire) : null;
    return measure ? { index: item.index, measure } : null;
  }

  private dragged(drag: Drag, world: Point): Geometry {
    const before = geometryOf(drag.measure);
    if (drag.handle.type === "radius") {
      const { points, size } = dragHandle(before, drag.handle, drag.from, world);
      return { points, size: Math.max(snapNumber(size, this.aim.grid), 0.1) };
    }
    if (drag.handle.type !== "whole") return dragHandle(before, drag.handle, drag.from, this.aim.snapped(world));
    const anchor = before.points[0] ?? drag.from;
    const to = this.aim.snapped({ x: anchor.x + world.x - drag.from.x, y: anchor.y + world.y - drag.from.y });
    return moveAll(before, to.x - anchor.x, to.y - anchor.y);
  }

  private showCursor(pointer: MapPointer): void {
    if (!this.aim.map) return;
    const grip = this.gripAt(pointer.screen, kReach);
    const pick = grip ? null : pointer.picks().find((p) => p.kind === "measure");
    this.aim.map.setHover(pick ?? null);
    this.aim.map.host.style.cursor = grip ? "move" : pick ? "pointer" : "default";
  }

  draw(pen: Pen): void {
    const chosen = this.drag ?? this.selected();
    if (!chosen) return;
    const geometry = this.drag?.now ?? geometryOf(chosen.measure);
    drawGeometry(pen, chosen.measure.kind, geometry, this.drag?.isMoved ? "draft" : "outline");
    for (const placed of handlesOf(chosen.measure.kind, geometry.points, geometry.size)) {
      const { handle } = placed;
      const isActive = handle.type === "corner" && handle.index === this.corner;
      drawHandle(pen, pen.camera.toScreen(placed), handle.type === "middle" ? "middle" : "corner", isActive);
    }
    if (!this.drag?.isMoved) return;
    const middle = pen.camera.toScreen(centreOf(geometry.points));
    pen.context.fillStyle = fade(pen.palette.selection, 0.2);
    drawNote(pen, { x: middle.x, y: middle.y - 14 }, noteOf(this.drag));
  }
}

function isSelected(items: readonly { kind: string; index: number }[], index: number): boolean {
  return items.length === 1 && items[0]?.kind === "measure" && items[0].index === index;
}

function noteOf({ handle, now }: Drag): string {
  if (handle.type === "radius") return `diameter ${round(now.size)} m`;
  const at =
    handle.type === "corner"
      ? now.points[handle.index]
      : handle.type === "middle"
        ? now.points[handle.after + 1]
        : now.points[0];
  return at ? `${round(at.x)}, ${round(at.y)}` : "";
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
