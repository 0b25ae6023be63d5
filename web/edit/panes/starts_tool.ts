// Where robots start, set with the mouse: a click adds a place, dragging moves one, a click on one takes it away.
import { distance, type Point } from "../../core/geometry.ts";
import { kDragStart } from "../../core/map/input.ts";
import type { MapView } from "../../core/map/map_view.ts";
import { fill, kSans, stroke, writeText } from "../../core/map/strokes.ts";
import type { MapPointer, MapTool, Pen } from "../../core/map/tool.ts";

const kReach = 12; // px
const kRadius = 9; // px

export interface StartPlaces {
  get(): readonly Point[];
  set(starts: readonly Point[]): void;
  /** A change is complete: the simulator may be told. */
  done(): void;
}

export class StartsTool implements MapTool {
  readonly name = "starts";
  readonly cursor = "crosshair";
  private map: MapView | null = null;
  private held = -1;
  private isNew = false;
  private origin: Point | null = null;
  private hasMoved = false;
  private before: readonly Point[] = [];

  constructor(private readonly places: StartPlaces) {}

  start(map: MapView): void {
    this.map = map;
  }

  down(pointer: MapPointer): void {
    this.before = this.places.get();
    this.origin = pointer.screen;
    this.hasMoved = false;
    this.held = this.at(pointer.screen);
    this.isNew = this.held < 0;
    if (!this.isNew) return;
    this.held = this.before.length;
    this.put([...this.before, rounded(pointer.world)]);
  }

  move(pointer: MapPointer, isDragging: boolean): void {
    if (!isDragging || this.held < 0 || !this.origin) return;
    if (!this.hasMoved && distance(this.origin, pointer.screen) <= kDragStart) return;
    this.hasMoved = true;
    this.put(this.places.get().map((start, i) => (i === this.held ? rounded(pointer.world) : start)));
  }

  up(): void {
    if (this.held >= 0 && !this.isNew && !this.hasMoved) this.put(this.before.filter((_, i) => i !== this.held));
    this.held = -1;
    this.places.done();
  }

  cancel(): void {
    if (this.held >= 0) this.put(this.before);
    this.held = -1;
  }

  /** Enter sets one in the middle of the map, Delete takes the last away. */
  key(event: KeyboardEvent): boolean {
    const { map } = this;
    if (!map) return false;
    if (event.key === "Enter") {
      const { width, height } = map.camera;
      this.put([...this.places.get(), rounded(map.camera.toWorld({ x: width / 2, y: height / 2 }))]);
    } else if (event.key === "Delete" || event.key === "Backspace") this.put(this.places.get().slice(0, -1));
    else if (event.key === "Escape") map.useTool(null);
    else return false;
    if (event.key !== "Escape") this.places.done();
    return true;
  }

  draw(pen: Pen): void {
    drawPlaces(pen, this.places.get());
  }

  private put(starts: readonly Point[]): void {
    this.places.set(starts);
    this.map?.redraw();
  }

  private at(screen: Point): number {
    const { map } = this;
    if (!map) return -1;
    return this.places.get().findIndex((start) => distance(map.camera.toScreen(start), screen) <= kReach);
  }
}

function drawPlaces(pen: Pen, starts: readonly Point[]): void {
  const { context, camera, palette } = pen;
  starts.forEach((start, i) => {
    const { x, y } = camera.toScreen(start);
    context.beginPath();
    context.arc(x, y, kRadius, 0, 2 * Math.PI);
    fill(pen, palette.halo);
    stroke(pen, { color: palette.selection, width: 2 });
    writeText(pen, String(i + 1), x, y, palette.ink, `600 11px ${kSans}`);
  });
}

/** To the decimetre: what a hand can mean. */
function rounded({ x, y }: Point): Point {
  return { x: Math.round(x * 10) / 10, y: Math.round(y * 10) / 10 };
}
