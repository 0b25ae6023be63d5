// Obstacles and objects by mouse: add, move, resize, nudge, remove.
import type { Point } from "../../core/geometry.ts";
import { kDragStart } from "../../core/map/input.ts";
import type { MapView } from "../../core/map/map_view.ts";
import { fade } from "../../core/map/palette.ts";
import type { MapPointer, MapTool, Pen } from "../../core/map/tool.ts";
import { kNothing, selectItem, toggleItem } from "../../core/selection.ts";
import { editMap, removeItems } from "../map_editing/edit_map.ts";
import { editStore } from "../map_editing/edit_store.ts";
import { drawHandle, drawNote } from "../map_editing/handles.ts";
import { nudgeOf, snapNumber, snapPoint, toolGrid } from "../map_editing/snap.ts";
import {
  editName,
  gripAt,
  isEditable,
  movedTo,
  radiusOf,
  type Thing,
  type ThingGrip,
  thingKey,
  withRadius,
} from "../map_editing/things.ts";
import type { Session } from "../session/session.ts";
import { addThing, indexOfThing, replaceThing, thingsOf } from "./scene_things.ts";

interface Drag {
  readonly grip: ThingGrip | "new";
  readonly from: Point;
  readonly before: readonly Thing[];
  now: readonly Thing[];
  isMoved: boolean;
}

export class WorldTool implements MapTool {
  readonly name = "world";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private drag: Drag | null = null;
  private downAt: Point = { x: 0, y: 0 };
  private endings: (() => void)[] = [];
  /** What was added or moved and is awaited in the next Scene, to be selected. */
  private expected: Thing | null = null;

  constructor(private readonly session: Session) {}

  start(map: MapView): void {
    this.map = map;
    this.endings = [editStore.subscribe(() => map.redraw()), map.model.subscribe("scene", () => this.takeScene())];
  }

  end(): void {
    for (const end of this.endings) end();
    this.cancel();
  }

  down(pointer: MapPointer): void {
    const { world, radius } = editStore.getState();
    this.downAt = pointer.screen;
    if (world !== "change") {
      const fresh = this.fresh(this.snapped(pointer.world), radius);
      this.drag = { grip: "new", from: { x: fresh.x, y: fresh.y }, before: [fresh], now: [fresh], isMoved: false };
      return;
    }
    const found = gripAt(this.things(), this.selectedKey(), pointer.world, this.reach(pointer.isTouch));
    if (!found) {
      if (!pointer.shift) this.session.model.select(kNothing);
      return;
    }
    const { thing, grip } = found;
    const { model } = this.session;
    if (pointer.shift) {
      model.select(toggleItem(model.get("selection"), { kind: thing.type, index: thing.index }));
      return;
    }
    const chosen = this.selectedThings();
    const isChosen = chosen.some((t) => thingKey(t) === thingKey(thing));
    if (!isChosen) model.select(selectItem({ kind: thing.type, index: thing.index }));
    const before = (isChosen && grip === "body" ? chosen : [thing]).filter(isEditable);
    if (before.length === 0) {
      this.session.ui.tell(
        "This obstacle comes from CREATE-OBSTACLES or the environment: it is no part of an overlay.",
        "hold",
      );
      return;
    }
    this.drag = { grip, from: pointer.world, before, now: before, isMoved: false };
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (!isDragging) {
      this.hover(pointer);
      return;
    }
    if (!this.drag) return;
    const way = Math.hypot(pointer.screen.x - this.downAt.x, pointer.screen.y - this.downAt.y);
    if (way > kDragStart) this.drag.isMoved = true;
    if (!this.drag.isMoved) return;
    this.drag.now = this.dragged(this.drag, pointer.world);
    this.map?.redraw();
  }

  up(): void {
    const { drag } = this;
    this.drag = null;
    this.map?.redraw();
    if (!drag) return;
    if (drag.grip === "new") this.add(drag.now[0] as Thing);
    else if (drag.isMoved) this.replace(drag.grip === "edge" ? "resize" : "move", drag.now);
  }

  cancel(): void {
    this.drag = null;
    this.map?.redraw();
  }

  leave(): void {
    this.map?.setHover(null);
  }

  key(event: KeyboardEvent): boolean {
    const { model } = this.session;
    if (event.key === "Escape" && editStore.getState().world !== "change" && !this.drag) {
      editStore.setState({ world: "change" });
      return true;
    }
    if (event.key === "Delete" || event.key === "Backspace") {
      void removeItems(this.session, model.get("selection").items);
      return true;
    }
    const step = nudgeOf(event.key, event.shiftKey, this.grid(), 1 / this.scale());
    const chosen = this.selectedThings().filter(isEditable);
    if (!step || chosen.length === 0 || event.ctrlKey || event.metaKey || event.altKey) return false;
    this.replace(
      "move",
      chosen.map((t) => movedTo(t, t.x + step.dx, t.y + step.dy)),
    );
    return true;
  }

  draw(pen: Pen): void {
    const shown = this.drag?.now ?? this.selectedThings();
    const { context, camera, palette } = pen;
    for (const thing of shown) {
      const at = camera.toScreen(thing);
      const radius = radiusOf(thing) * camera.scale;
      context.beginPath();
      context.arc(at.x, at.y, Math.max(radius, 3), 0, 2 * Math.PI);
      context.fillStyle = fade(palette.selection, this.drag ? 0.3 : 0.12);
      context.fill();
      context.lineWidth = 1.5;
      context.strokeStyle = palette.selection;
      context.setLineDash(isEditable(thing) || this.drag?.grip === "new" ? [] : [4, 3]);
      context.stroke();
      context.setLineDash([]);
    }
    const only = shown.length === 1 ? (shown[0] as Thing) : null;
    if (!only) return;
    const at = camera.toScreen(only);
    const edge = Math.max(radiusOf(only) * camera.scale, this.reach(false) * camera.scale * 1.5);
    if (isEditable(only) && !this.drag) drawHandle(pen, { x: at.x + edge, y: at.y }, "corner", false);
    if (this.drag) drawNote(pen, { x: at.x, y: at.y - edge - 10 }, noteOf(only));
  }

  private hover(pointer: MapPointer): void {
    if (!this.map || editStore.getState().world !== "change") return;
    const found = gripAt(this.things(), this.selectedKey(), pointer.world, this.reach(pointer.isTouch));
    this.map.setHover(found ? { kind: found.thing.type, index: found.thing.index } : null);
    this.map.host.style.cursor = !found ? "default" : found.grip === "edge" ? "ew-resize" : "move";
  }

  private dragged(drag: Drag, world: Point): readonly Thing[] {
    const first = drag.before[0] as Thing;
    if (drag.grip !== "body") {
      const radius = Math.hypot(world.x - first.x, world.y - first.y);
      return [withRadius(first, Math.max(snapNumber(radius, this.grid() / 5), 1e-2))];
    }
    const to = this.snapped({ x: first.x + world.x - drag.from.x, y: first.y + world.y - drag.from.y });
    return drag.before.map((t) => movedTo(t, t.x + to.x - first.x, t.y + to.y - first.y));
  }

  private add(thing: Thing): void {
    this.expected = thing;
    void editMap(this.session, `add ${thing.type}`, [addThing(thing)], editStore.getState().document);
  }

  private replace(verb: string, things: readonly Thing[]): void {
    void editMap(this.session, editName(verb, things), things.map(replaceThing));
  }

  private takeScene(): void {
    const scene = this.session.model.get("scene");
    const index = scene && this.expected ? indexOfThing(scene, this.expected) : -1;
    if (!this.expected || index < 0) return;
    this.session.model.select(selectItem({ kind: this.expected.type, index }));
    this.expected = null;
  }

  private fresh(at: Point, radius: number): Thing {
    const scene = this.session.model.get("scene");
    const size = radius > 0 ? radius : snapNumber(Math.min(scene?.width ?? 100, scene?.height ?? 100) / 60, 0.1) || 0.5;
    const { world, style, color } = editStore.getState();
    const common = { index: -1, x: at.x, y: at.y, document: "" };
    return world === "obstacle"
      ? { type: "obstacle", ...common, radius: size, height: 0 }
      : { type: "object", ...common, diameter: radius > 0 ? 2 * radius : Math.min(2 * size, 1), style, color };
  }

  private things(): Thing[] {
    return thingsOf(this.session.model.get("scene"), this.session.model.movedObjects);
  }

  private selectedThings(): Thing[] {
    const { items } = this.session.model.get("selection");
    if (items.length === 0) return [];
    const keys = new Set(items.map((item) => `${item.kind}/${item.index}`));
    return this.things().filter((t) => keys.has(thingKey(t)));
  }

  private selectedKey(): string | null {
    const chosen = this.selectedThings();
    return chosen.length === 1 ? thingKey(chosen[0] as Thing) : null;
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

  private reach(isTouch: boolean): number {
    return (isTouch ? 18 : 8) / this.scale();
  }
}

function noteOf(thing: Thing): string {
  const size = thing.type === "obstacle" ? `radius ${round(thing.radius)} m` : `diameter ${round(thing.diameter)} m`;
  return `${round(thing.x)}, ${round(thing.y)} · ${size}`;
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
