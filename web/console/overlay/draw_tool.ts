// Control measures by mouse: drawn point by point or by dragging; those that stand are changed by their handles.
import { centreOf, distance, type Point } from "../../core/geometry.ts";
import type { MapView } from "../../core/map/map_view.ts";
import { fade } from "../../core/map/palette.ts";
import type { MapPointer, MapTool, Pen } from "../../core/map/tool.ts";
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";
import { kNothing, selectItem } from "../../core/selection.ts";
import { editMap, removeItems } from "../map_editing/edit_map.ts";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";
import { drawHandle, drawNote } from "../map_editing/handles.ts";
import { nudgeOf, snapNumber, snapPoint, toolGrid } from "../map_editing/snap.ts";
import type { Session } from "../session/session.ts";
import {
  addPoint,
  canBeCircle,
  circleDraft,
  type Draft,
  emptyDraft,
  isFull,
  missing,
  removeLastPoint,
} from "./draft.ts";
import { drawingStore } from "./drawing_store.ts";
import { proposeName } from "./names.ts";
import {
  addMeasure,
  type EditedMeasure,
  editedMeasure,
  geometryOf,
  measureOfDraft,
  replaceMeasure,
  titleOf,
  withGeometry,
} from "./scene_measures.ts";
import { drawGeometry } from "./sketch.ts";
import { dragHandle, type Geometry, type Handle, handlesOf, moveAll, removeCorner } from "./vertices.ts";

interface Drag {
  readonly index: number;
  readonly measure: EditedMeasure;
  readonly handle: Handle;
  readonly from: Point;
  now: Geometry;
  isMoved: boolean;
}

const kDragStart = 4; // px
const kReach = 9; // px
const kTouchReach = 20;

export class DrawTool implements MapTool {
  readonly name = "draw";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private drag: Drag | null = null;
  private downAt: Point | null = null;
  private downWorld: Point = { x: 0, y: 0 };
  private hover: Point | null = null;
  /** Its corner that keys move and remove. */
  private corner = -1;
  private awaited: EditedMeasure | null = null;
  private endings: (() => void)[] = [];

  constructor(private readonly session: Session) {}

  start(map: MapView): void {
    this.map = map;
    const { model } = this.session;
    this.endings = [
      editStore.subscribe((now, before) => now.kind !== before.kind && this.takeKind()),
      drawingStore.subscribe(() => map.redraw()),
      model.subscribe("scene", () => this.takeScene()),
      model.subscribe("selection", () => this.forgetCorner()),
    ];
    this.takeKind();
  }

  end(): void {
    for (const end of this.endings) end();
    this.cancel();
    changeEditing({ kind: null });
    drawingStore.setState({ draft: null });
  }

  down(pointer: MapPointer): void {
    this.downAt = pointer.screen;
    this.downWorld = this.snapped(pointer.world);
    if (this.draft()) return;
    const reach = pointer.isTouch ? kTouchReach : kReach;
    const grip = this.gripAt(pointer.screen, reach) ?? this.pick(pointer);
    if (!grip) {
      this.session.model.select(kNothing);
      return;
    }
    this.corner = grip.handle.type === "corner" ? grip.handle.index : -1;
    this.drag = { ...grip, from: pointer.world, now: geometryOf(grip.measure), isMoved: false };
    this.map?.redraw();
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    this.hover = this.snapped(pointer.world);
    const draft = this.draft();
    if (draft) {
      if (isDragging && this.isDragged(pointer) && draft.points.length === 0 && canBeCircle(kindInfo(draft.kind))) {
        drawingStore.setState({ draft: { ...this.circle(draft.kind, pointer.world), points: [] } });
      }
    } else if (this.drag && isDragging) {
      this.drag.isMoved ||= this.isDragged(pointer);
      if (this.drag.isMoved) this.drag.now = this.dragged(this.drag, pointer.world);
    } else this.showCursor(pointer);
    this.map?.redraw();
  }

  up(pointer: MapPointer): void {
    const draft = this.draft();
    const { drag } = this;
    this.drag = null;
    if (draft) this.click(draft, pointer);
    else if (drag?.isMoved)
      this.replace(drag.index, drag.measure, drag.now, drag.handle.type === "whole" ? "move" : "change");
    this.downAt = null;
    this.map?.redraw();
  }

  doubleClick(pointer: MapPointer): void {
    const draft = this.draft();
    if (draft) {
      this.finish(draft);
      return;
    }
    const grip = this.gripAt(pointer.screen, kReach);
    if (grip?.handle.type === "corner") this.removeCornerOf(grip.index, grip.measure, grip.handle.index);
  }

  cancel(): void {
    this.drag = null;
    this.downAt = null;
    this.map?.redraw();
  }

  leave(): void {
    this.hover = null;
    this.map?.setHover(null);
    this.map?.redraw();
  }

  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const draft = this.draft();
    return draft ? this.keyOfDraft(draft, event) : this.keyOfSelected(event);
  }

  draw(pen: Pen): void {
    const draft = this.draft();
    if (draft) this.drawDraft(pen, draft);
    else this.drawSelected(pen);
  }

  private keyOfDraft(draft: Draft, event: KeyboardEvent): boolean {
    switch (event.key) {
      case "Enter":
        // Without a pointer: points are set where the middle of the map is.
        if (draft.points.length === 0) this.setDraft(addPoint(draft, this.hover ?? this.middle()));
        else this.finish(draft);
        return true;
      case "Backspace":
      case "Delete":
        this.setDraft(removeLastPoint(draft));
        return true;
      case "Escape":
        if (draft.points.length > 0 || this.downAt) this.setDraft(emptyDraft(draft.kind));
        else changeEditing({ kind: null });
        this.downAt = null;
        return true;
      default:
        return false;
    }
  }

  private keyOfSelected(event: KeyboardEvent): boolean {
    const chosen = this.selected();
    if (!chosen) return false;
    const { index, measure } = chosen;
    if (event.key === "Delete" || event.key === "Backspace") {
      if (this.corner >= 0 && this.removeCornerOf(index, measure, this.corner)) return true;
      void removeItems(this.session, [{ kind: "measure", index }]);
      return true;
    }
    const step = nudgeOf(event.key, event.shiftKey, this.grid(), 1 / this.scale());
    if (!step) return false;
    const before = geometryOf(measure);
    const at = before.points[this.corner];
    const now = at
      ? dragHandle(before, { type: "corner", index: this.corner }, at, { x: at.x + step.dx, y: at.y + step.dy })
      : moveAll(before, step.dx, step.dy);
    this.replace(index, measure, now, at ? "change" : "move");
    return true;
  }

  private click(draft: Draft, pointer: MapPointer): void {
    const isCircle = draft.points.length === 0 && this.isDragged(pointer) && canBeCircle(kindInfo(draft.kind));
    if (isCircle) {
      this.finish(this.circle(draft.kind, pointer.world));
      return;
    }
    const next = addPoint({ ...draft, size: 0 }, this.snapped(pointer.world), kDragStart / this.scale());
    this.setDraft(next);
    if (isFull(next)) this.finish(next);
  }

  /** From where the button went down to here. */
  private circle(kind: MeasureKind, edge: Point): Draft {
    const made = circleDraft(kind, this.downWorld, edge);
    const least = this.grid() || 0.1;
    return { ...made, size: Math.max(snapNumber(made.size, least), least) };
  }

  private finish(draft: Draft): void {
    if (missing(draft) !== "") {
      this.session.ui.tell(missing(draft), "hold");
      return;
    }
    const scene = this.session.model.get("scene");
    const name = proposeName(draft.kind, scene?.measures.map((m) => m.name) ?? []);
    const measure = measureOfDraft(draft, name);
    this.awaited = measure;
    changeEditing({ kind: null });
    void editMap(this.session, `draw ${name}`, [addMeasure(measure)], editStore.getState().document).then((isDone) => {
      if (!isDone) this.awaited = null;
    });
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

  /** A measure that was drawn is selected when it comes back, so that it can be named. */
  private takeScene(): void {
    const { awaited } = this;
    const measures = this.session.model.get("scene")?.measures ?? [];
    const index = awaited ? measures.findLastIndex((m) => m.name === awaited.name) : -1;
    if (index < 0) return;
    this.awaited = null;
    this.session.model.select(selectItem({ kind: "measure", index }));
    drawingStore.setState({ naming: index });
  }

  private takeKind(): void {
    const { kind } = editStore.getState();
    this.setDraft(kind ? emptyDraft(kind) : null);
    if (kind) this.session.model.select(kNothing);
  }

  private forgetCorner(): void {
    this.corner = -1;
    this.map?.redraw();
  }

  private gripAt(screen: Point, reach: number): Omit<Drag, "from" | "now" | "isMoved"> | null {
    const chosen = this.selected();
    if (!chosen || !this.map) return null;
    const { index, measure } = chosen;
    const { points, size } = geometryOf(measure);
    let best: Handle | null = null;
    let least = reach;
    for (const placed of handlesOf(measure.kind, points, size)) {
      const away = distance(this.map.camera.toScreen(placed), screen);
      if (away > least) continue;
      least = away;
      best = placed.handle;
    }
    return best ? { index, measure, handle: best } : null;
  }

  private pick(pointer: MapPointer): Omit<Drag, "from" | "now" | "isMoved"> | null {
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
      return { points, size: Math.max(snapNumber(size, this.grid()), 0.1) };
    }
    if (drag.handle.type !== "whole") return dragHandle(before, drag.handle, drag.from, this.snapped(world));
    const anchor = before.points[0] ?? drag.from;
    const to = this.snapped({ x: anchor.x + world.x - drag.from.x, y: anchor.y + world.y - drag.from.y });
    return moveAll(before, to.x - anchor.x, to.y - anchor.y);
  }

  private showCursor(pointer: MapPointer): void {
    if (!this.map) return;
    const grip = this.gripAt(pointer.screen, kReach);
    const pick = grip ? null : pointer.picks().find((p) => p.kind === "measure");
    this.map.setHover(pick ?? null);
    this.map.host.style.cursor = grip ? "move" : pick ? "pointer" : "default";
  }

  private drawDraft(pen: Pen, draft: Draft): void {
    const isCircle = draft.points.length === 0 && draft.size > 0;
    const points = isCircle ? [this.downWorld] : draft.points;
    const next = this.hover && !isCircle && !isFull(draft) ? [...points, this.hover] : points;
    if (next.length > 0) drawGeometry(pen, draft.kind, { points: next, size: draft.size }, "draft");
    for (const point of points) drawHandle(pen, pen.camera.toScreen(point), "corner", false);
    const last = points.at(-1);
    if (isCircle) {
      const at = pen.camera.toScreen(this.downWorld);
      drawNote(pen, { x: at.x, y: at.y - 24 }, `diameter ${Math.round(draft.size * 10) / 10} m`);
    } else if (last && this.hover) {
      const at = pen.camera.toScreen(this.hover);
      drawNote(pen, { x: at.x, y: at.y - 26 }, `${Math.round(distance(last, this.hover) * 10) / 10} m`);
    }
  }

  private drawSelected(pen: Pen): void {
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

  private draft(): Draft | null {
    return drawingStore.getState().draft;
  }

  private setDraft(draft: Draft | null): void {
    drawingStore.setState({ draft });
    this.map?.redraw();
  }

  private isDragged(pointer: MapPointer): boolean {
    return this.downAt !== null && distance(this.downAt, pointer.screen) > kDragStart;
  }

  private middle(): Point {
    return this.snapped({ x: this.map?.camera.x ?? 0, y: this.map?.camera.y ?? 0 });
  }

  private snapped(point: Point): Point {
    return snapPoint(point, this.grid());
  }

  private grid(): number {
    return editStore.getState().grid ? toolGrid(this.scale()) : 0;
  }

  private scale(): number {
    return this.map?.camera.scale ?? 1;
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
