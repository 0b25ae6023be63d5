// Drawing a new control measure: point by point, or a circle by dragging.
import { distance, type Point } from "../../core/geometry.ts";
import type { MapPointer, Pen } from "../../core/map/tool.ts";
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";
import { kNothing, selectItem } from "../../core/selection.ts";
import { editMap } from "../map_editing/edit_map.ts";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";
import { drawHandle, drawNote } from "../map_editing/handles.ts";
import { snapNumber } from "../map_editing/snap.ts";
import type { Session } from "../session/session.ts";
import type { Aim } from "./aim.ts";
import {
  addPoint,
  canBeCircle,
  circleDraft,
  type Draft,
  emptyDraft,
  isFull,
  missingInDraft,
  removeLastPoint,
} from "./draft.ts";
import { drawingStore } from "./drawing_store.ts";
import { proposeName } from "./names.ts";
import { addMeasure, type EditedMeasure, measureOfDraft } from "./scene_measures.ts";
import { drawGeometry } from "./sketch.ts";

export class Drafting {
  /** Drawn, and not yet in the scene. */
  private awaited: EditedMeasure | null = null;

  constructor(
    private readonly session: Session,
    private readonly aim: Aim,
  ) {}

  /** What is being drawn; nothing: what stands is changed. */
  get draft(): Draft | null {
    return drawingStore.getState().draft;
  }

  drag(draft: Draft, pointer: MapPointer): void {
    if (this.isCircle(draft, pointer))
      drawingStore.setState({ draft: { ...this.circle(draft.kind, pointer.world), points: [] } });
  }

  key(draft: Draft, event: KeyboardEvent): boolean {
    switch (event.key) {
      case "Enter":
        // Without a pointer: points are set where the middle of the map is.
        if (draft.points.length === 0) this.setDraft(addPoint(draft, this.aim.over ?? this.aim.middle));
        else this.finish(draft);
        return true;
      case "Backspace":
      case "Delete":
        this.setDraft(removeLastPoint(draft));
        return true;
      case "Escape":
        if (draft.points.length > 0 || this.aim.isDown) this.setDraft(emptyDraft(draft.kind));
        else changeEditing({ kind: null });
        this.aim.lift();
        return true;
      default:
        return false;
    }
  }

  click(draft: Draft, pointer: MapPointer): void {
    if (this.isCircle(draft, pointer)) {
      this.finish(this.circle(draft.kind, pointer.world));
      return;
    }
    const next = addPoint({ ...draft, size: 0 }, this.aim.snapped(pointer.world), this.aim.tolerance);
    this.setDraft(next);
    if (isFull(next)) this.finish(next);
  }

  /** From where the button went down to here. */
  private circle(kind: MeasureKind, edge: Point): Draft {
    const made = circleDraft(kind, this.aim.downWorld, edge);
    const least = this.aim.grid || 0.1;
    return { ...made, size: Math.max(snapNumber(made.size, least), least) };
  }

  finish(draft: Draft): void {
    if (missingInDraft(draft) !== "") {
      this.session.ui.tell(missingInDraft(draft), "hold");
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

  /** A measure that was drawn is selected when it comes back, so that it can be named. */
  takeScene(): void {
    const { awaited } = this;
    const measures = this.session.model.get("scene")?.measures ?? [];
    const index = awaited ? measures.findLastIndex((m) => m.name === awaited.name) : -1;
    if (index < 0) return;
    this.awaited = null;
    this.session.model.select(selectItem({ kind: "measure", index }));
    drawingStore.setState({ naming: index });
  }

  takeKind(): void {
    const { kind } = editStore.getState();
    this.setDraft(kind ? emptyDraft(kind) : null);
    if (kind) this.session.model.select(kNothing);
  }

  draw(pen: Pen, draft: Draft): void {
    const isCircle = draft.points.length === 0 && draft.size > 0;
    const points = isCircle ? [this.aim.downWorld] : draft.points;
    const next = this.aim.over && !isCircle && !isFull(draft) ? [...points, this.aim.over] : points;
    if (next.length > 0) drawGeometry(pen, draft.kind, { points: next, size: draft.size }, "draft");
    for (const point of points) drawHandle(pen, pen.camera.toScreen(point), "corner", false);
    const last = points.at(-1);
    if (isCircle) {
      const at = pen.camera.toScreen(this.aim.downWorld);
      drawNote(pen, { x: at.x, y: at.y - 24 }, `diameter ${Math.round(draft.size * 10) / 10} m`);
    } else if (last && this.aim.over) {
      const at = pen.camera.toScreen(this.aim.over);
      drawNote(pen, { x: at.x, y: at.y - 26 }, `${Math.round(distance(last, this.aim.over) * 10) / 10} m`);
    }
  }

  private setDraft(draft: Draft | null): void {
    drawingStore.setState({ draft });
    this.aim.redraw();
  }

  private isCircle(draft: Draft, pointer: MapPointer): boolean {
    return draft.points.length === 0 && this.aim.isDragged(pointer) && canBeCircle(kindInfo(draft.kind));
  }
}
