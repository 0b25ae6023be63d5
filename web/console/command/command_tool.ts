// Commands by mouse: a click is the goal, a drag from it the heading of the formation there.
import { centreOf, type Point } from "../../core/geometry.ts";
import type { MapView } from "../../core/map/map_view.ts";
import { fade } from "../../core/map/palette.ts";
import type { MapPointer, MapTool, Pen } from "../../core/map/tool.ts";
import { headingOfDrag } from "../../core/mdl_text.ts";
import { kindOfWire } from "../../core/measure_kinds.ts";
import { drawNote } from "../map_editing/handles.ts";
import type { Session } from "../session/session.ts";
import { dropGoal, type Goal, orderStore, takesMorePlaces } from "./order_store.ts";
import { nearestLine, type PlaceMeasure, snapToCenter } from "./places.ts";

const kDragStart = 6; // px
const kSnap = 16; // px
const kLineReach = 10; // px
const kArrow = 72; // px, of the heading before it is dragged further

function drawCross({ context }: Pen, at: Point, color: string): void {
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(at.x, at.y, 9, 0, 2 * Math.PI);
  context.moveTo(at.x - 14, at.y);
  context.lineTo(at.x + 14, at.y);
  context.moveTo(at.x, at.y - 14);
  context.lineTo(at.x, at.y + 14);
  context.stroke();
}

/** The measures of the Scene, at the same indices. Those of unknown kinds have no points. */
export function placeMeasures(session: Session): PlaceMeasure[] {
  return (session.model.get("scene")?.measures ?? []).map((m) => {
    const info = kindOfWire(m.kind);
    return { kind: info?.kind ?? "boundary", name: m.name, size: m.size, points: info ? m.points : [] };
  });
}

export class CommandTool implements MapTool {
  readonly name = "command";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private downAt: Point | null = null;
  private hover: Goal | null = null;
  private tip: Point | null = null;
  private ending: (() => void) | null = null;

  constructor(private readonly session: Session) {}

  start(map: MapView): void {
    this.map = map;
    this.ending = orderStore.subscribe(() => map.redraw());
  }

  end(): void {
    this.ending?.();
    dropGoal();
  }

  down(pointer: MapPointer): void {
    this.downAt = pointer.screen;
    this.tip = null;
    const goal = this.goalAt(pointer.world);
    const order = orderStore.getState();
    if (takesMorePlaces(order)) {
      this.downAt = null;
      orderStore.setState({ more: [...order.more, goal] });
      return;
    }
    orderStore.setState({ goal, more: [], heading: null, isDragging: true, task: this.taskFor(order.task, goal) });
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (!isDragging) {
      this.hover = this.goalAt(pointer.world);
      this.map?.redraw();
      return;
    }
    const { goal } = orderStore.getState();
    if (!goal || !this.downAt || !this.map) return;
    const from = this.map.camera.toScreen(goal.at);
    const dx = pointer.screen.x - from.x;
    const dy = from.y - pointer.screen.y;
    const isFar = Math.hypot(pointer.screen.x - this.downAt.x, pointer.screen.y - this.downAt.y) > kDragStart;
    if (!isFar && this.tip === null) return;
    this.tip = pointer.screen;
    orderStore.setState({ heading: headingOfDrag(dx, dy, pointer.shift ? 1 : 5) });
  }

  up(): void {
    this.downAt = null;
    this.tip = null;
    orderStore.setState({ isDragging: false });
  }

  cancel(): void {
    this.downAt = null;
    this.tip = null;
    dropGoal();
  }

  leave(): void {
    this.hover = null;
    this.map?.redraw();
  }

  key(event: KeyboardEvent): boolean {
    const { goal, more, heading } = orderStore.getState();
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    if (event.key === "Escape" && goal) {
      dropGoal();
      return true;
    }
    if (event.key === "Enter" && !goal && this.map) {
      // Without a pointer: the goal is where the middle of the map is.
      orderStore.setState({
        goal: this.goalAt({ x: this.map.camera.x, y: this.map.camera.y }),
        more: [],
        heading: null,
      });
      return true;
    }
    if (event.key === "Backspace" && more.length > 0) {
      orderStore.setState({ more: more.slice(0, -1) });
      return true;
    }
    if (goal && (event.key === "<" || event.key === ">")) {
      const turned = (heading ?? 0) + (event.key === "<" ? 5 : -5);
      orderStore.setState({ heading: ((turned % 360) + 360) % 360 });
      return true;
    }
    return false;
  }

  draw(pen: Pen): void {
    const { goal, more, heading } = orderStore.getState();
    const shown = goal ?? this.hover;
    if (!shown) return;
    const { palette, camera } = pen;
    const at = camera.toScreen(shown.at);
    drawCross(pen, at, goal ? palette.goal : fade(palette.goal, 0.6));
    if (!goal && shown.measure !== null) drawNote(pen, { x: at.x, y: at.y - 28 }, this.nameOf(shown.measure));
    if (goal && heading !== null) this.drawHeading(pen, at, heading);
    more.forEach((one, i) => {
      const place = camera.toScreen(one.at);
      drawCross(pen, place, palette.goal);
      drawNote(pen, { x: place.x, y: place.y - 28 }, String(i + 2));
    });
    if (goal && more.length > 0) drawNote(pen, { x: at.x, y: at.y - 28 }, "1");
  }

  private drawHeading(pen: Pen, at: Point, heading: number): void {
    const { context, palette } = pen;
    const angle = (heading * Math.PI) / 180;
    const length = this.tip ? Math.max(kArrow, Math.hypot(this.tip.x - at.x, this.tip.y - at.y)) : kArrow;
    const dx = Math.cos(angle);
    const dy = -Math.sin(angle);
    const tip = { x: at.x + dx * length, y: at.y + dy * length };
    context.strokeStyle = palette.goal;
    context.fillStyle = palette.goal;
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(at.x, at.y);
    context.lineTo(tip.x - dx * 10, tip.y - dy * 10);
    // The front of the formation.
    context.moveTo(at.x - dy * 26, at.y + dx * 26);
    context.lineTo(at.x + dy * 26, at.y - dx * 26);
    context.stroke();
    context.beginPath();
    context.moveTo(tip.x, tip.y);
    context.lineTo(tip.x - dx * 14 - dy * 7, tip.y - dy * 14 + dx * 7);
    context.lineTo(tip.x - dx * 14 + dy * 7, tip.y - dy * 14 - dx * 7);
    context.fill();
    drawNote(pen, { x: tip.x + dx * 26, y: tip.y + dy * 18 }, `${heading}°`);
  }

  private goalAt(world: Point): Goal {
    const measures = placeMeasures(this.session);
    const scale = this.map?.camera.scale ?? 1;
    const measure = snapToCenter(measures, world, kSnap / scale);
    const line = nearestLine(measures, world, kLineReach / scale);
    const points = measure === null ? [] : (measures[measure]?.points ?? []);
    return { at: points.length > 0 ? centreOf(points) : world, measure, line };
  }

  /** Following needs a line, and searching a place of the map: where there is none the unit just moves there. */
  private taskFor(task: ReturnType<typeof orderStore.getState>["task"], goal: Goal) {
    if (task === "FOLLOW" && goal.line === null) return "MOVETO";
    return task === "SEARCH" && goal.measure === null ? "MOVETO" : task;
  }

  private nameOf(measure: number): string {
    return this.session.model.get("scene")?.measures[measure]?.name || "middle";
  }
}
