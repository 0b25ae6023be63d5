// Selecting: click, shift-click, a box drawn over empty ground, again on the same place for what lies below.
import { boxOf, distance, type Point } from "../geometry.ts";
import {
  kNothing,
  type Selection,
  selectItem,
  selectRobots,
  selectUnit,
  toggleItem,
  toggleRobot,
} from "../selection.ts";
import { kDragStart } from "./input.ts";
import type { MapView } from "./map_view.ts";
import { fade } from "./palette.ts";
import type { MapPick, MapPointer, MapTool, Pen } from "./tool.ts";

const kDoubleClick = 500; // ms between its two clicks, at most

export class SelectTool implements MapTool {
  readonly name = "select";
  private map: MapView | null = null;
  private origin: MapPointer | null = null;
  private corner: Point | null = null;
  private lastClick: Point | null = null;
  /** The robot that was clicked last, and when [ms]: by a second click it may have moved on. */
  private lastRobot = { id: 0, at: 0 };
  private depth = 0;
  private finger: Point | null = null;

  start(map: MapView): void {
    this.map = map;
  }

  end(): void {
    this.cancel();
    this.map?.setHover(null);
  }

  down(pointer: MapPointer): void {
    this.origin = pointer;
    this.corner = null;
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (!isDragging) {
      const [first] = pointer.picks();
      this.map?.setHover(first ?? null);
      if (this.map) this.map.host.style.cursor = first ? "pointer" : "default";
    } else if (pointer.isTouch) {
      this.dragByFinger(pointer);
    } else if (this.corner || (this.origin && distance(this.origin.screen, pointer.screen) > kDragStart)) {
      this.corner = pointer.screen;
      this.map?.redraw();
    }
  }

  up(pointer: MapPointer): void {
    if (this.finger) this.finger = null;
    else if (this.corner) this.selectBox(pointer);
    else this.click(pointer);
    this.cancel();
  }

  /** Of a robot: its whole unit. */
  doubleClick(pointer: MapPointer): void {
    const hit = pointer.picks().find((pick) => pick.kind === "robot");
    const id = this.isSecondClick() ? this.lastRobot.id : hit?.kind === "robot" ? hit.id : 0;
    const roster = this.map?.model.get("roster");
    if (id === 0 || !roster) return;
    const unit = roster.robot(id)?.unit ?? "";
    if (unit) this.map?.model.select(selectUnit(unit, roster.robotsOf(unit)));
  }

  leave(): void {
    this.map?.setHover(null);
  }

  cancel(): void {
    this.origin = null;
    this.corner = null;
    this.finger = null;
    this.map?.redraw();
  }

  key(event: KeyboardEvent): boolean {
    const { model } = this.map!;
    if (event.key === "Escape" && !this.origin && model.get("selection") !== kNothing) {
      model.select(kNothing);
      return true;
    }
    if (event.key === "a" && (event.ctrlKey || event.metaKey)) {
      model.select(selectRobots(model.get("roster").robots.map((robot) => robot.id)));
      return true;
    }
    return false;
  }

  isDrawing(): boolean {
    return this.corner !== null;
  }

  draw({ context, palette }: Pen): void {
    if (!this.origin || !this.corner) return;
    const { x, y } = this.origin.screen;
    context.fillStyle = fade(palette.selection, 0.1);
    context.strokeStyle = palette.selection;
    context.lineWidth = 1;
    context.fillRect(x, y, this.corner.x - x, this.corner.y - y);
    context.strokeRect(x, y, this.corner.x - x, this.corner.y - y);
  }

  /** One finger moves the map: boxes are for mice. */
  private dragByFinger({ screen }: MapPointer): void {
    const last = this.finger ?? this.origin!.screen;
    if (!this.finger && distance(last, screen) <= kDragStart * 2) return;
    this.map!.framing.pan(screen.x - last.x, screen.y - last.y);
    this.finger = screen;
  }

  private click(pointer: MapPointer): void {
    const picks = pointer.picks();
    const isAgain = this.lastClick !== null && distance(this.lastClick, pointer.screen) <= kDragStart;
    this.depth = isAgain && !pointer.shift ? this.depth + 1 : 0;
    this.lastClick = pointer.screen;
    const model = this.map!.model;
    const pick = picks.length ? this.choose(picks) : undefined;
    const selection = model.get("selection");
    // The second of a double click means what the first one hit.
    const isSecond = isAgain && this.isSecondClick();
    if (isSecond && !picks.some((one) => one.kind === "robot" && one.id === this.lastRobot.id)) return;
    if (!isSecond) this.lastRobot = { id: pick?.kind === "robot" ? pick.id : 0, at: performance.now() };
    const isMore = pointer.shift || pointer.ctrl;
    if (pick) model.select(isMore ? toggled(selection, pick) : chosen(pick));
    else if (!pointer.shift) model.select(kNothing);
  }

  private isSecondClick(): boolean {
    return this.lastRobot.id !== 0 && performance.now() - this.lastRobot.at < kDoubleClick;
  }

  /** The next below with each click on the same place. */
  private choose(picks: readonly MapPick[]): MapPick {
    return picks[this.depth % picks.length]!;
  }

  private selectBox(pointer: MapPointer): void {
    const { model, robotsIn, itemsIn } = bound(this.map!);
    const box = boxOf(this.origin!.world, pointer.world);
    const before = pointer.shift ? model.get("selection") : kNothing;
    const robots = [...new Set([...before.robots, ...robotsIn(box)])];
    // Robots are what is meant; things are chosen where no robot is in the box.
    const items = robots.length ? before.items : [...before.items, ...itemsIn(box)];
    model.select(robots.length || items.length ? { robots, unit: "", items } : kNothing);
    this.lastClick = null;
  }
}

function chosen(pick: MapPick): Selection {
  return pick.kind === "robot" ? selectRobots([pick.id]) : selectItem(pick);
}

function toggled(selection: Selection, pick: MapPick): Selection {
  return pick.kind === "robot" ? toggleRobot(selection, pick.id) : toggleItem(selection, pick);
}

function bound(map: MapView) {
  return { model: map.model, robotsIn: map.robotsIn.bind(map), itemsIn: map.itemsIn.bind(map) };
}
