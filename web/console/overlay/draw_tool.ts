// Control measures by mouse: drawn point by point or by dragging; those that stand are changed by their handles.
import type { MapView } from "../../core/map/map_view.ts";
import type { MapPointer, MapTool, Pen } from "../../core/map/tool.ts";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";
import type { Session } from "../session/session.ts";
import { Aim } from "./aim.ts";
import { Drafting } from "./drafting.ts";
import { drawingStore } from "./drawing_store.ts";
import { Reshaping } from "./reshaping.ts";

export class DrawTool implements MapTool {
  readonly name = "draw";
  readonly cursor = "crosshair";
  private readonly aim = new Aim();
  private readonly drafting: Drafting;
  private readonly reshaping: Reshaping;
  private endings: (() => void)[] = [];

  constructor(private readonly session: Session) {
    this.drafting = new Drafting(session, this.aim);
    this.reshaping = new Reshaping(session, this.aim);
  }

  start(map: MapView): void {
    this.aim.map = map;
    const { model } = this.session;
    this.endings = [
      editStore.subscribe((now, before) => now.kind !== before.kind && this.drafting.takeKind()),
      drawingStore.subscribe(() => map.redraw()),
      model.subscribe("scene", () => this.drafting.takeScene()),
      model.subscribe("selection", () => this.reshaping.forgetCorner()),
    ];
    this.drafting.takeKind();
  }

  end(): void {
    for (const end of this.endings) end();
    this.cancel();
    changeEditing({ kind: null });
    drawingStore.setState({ draft: null });
  }

  down(pointer: MapPointer): void {
    this.aim.down(pointer);
    if (!this.drafting.draft) this.reshaping.down(pointer);
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    this.aim.over = this.aim.snapped(pointer.world);
    const { draft } = this.drafting;
    if (!draft) this.reshaping.move(pointer, isDragging);
    else if (isDragging) this.drafting.drag(draft, pointer);
    this.aim.redraw();
  }

  up(pointer: MapPointer): void {
    const { draft } = this.drafting;
    if (draft) {
      this.reshaping.letGo();
      this.drafting.click(draft, pointer);
    } else this.reshaping.up();
    this.aim.lift();
    this.aim.redraw();
  }

  doubleClick(pointer: MapPointer): void {
    const { draft } = this.drafting;
    if (draft) this.drafting.finish(draft);
    else this.reshaping.doubleClick(pointer);
  }

  cancel(): void {
    this.reshaping.letGo();
    this.aim.lift();
    this.aim.redraw();
  }

  leave(): void {
    this.aim.over = null;
    this.aim.map?.setHover(null);
    this.aim.redraw();
  }

  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const { draft } = this.drafting;
    return draft ? this.drafting.key(draft, event) : this.reshaping.key(event);
  }

  draw(pen: Pen): void {
    const { draft } = this.drafting;
    if (draft) this.drafting.draw(pen, draft);
    else this.reshaping.draw(pen);
  }
}
