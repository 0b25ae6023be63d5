// Where robots have been: lines in their colours, which stay or fade.
import type { Camera } from "../camera.ts";
import { parseColor, readableOn, toHex } from "../color.ts";
import { overlaps } from "../geometry.ts";
import type { Model } from "../model.ts";
import type { Trail } from "../trails.ts";
import { pen2d } from "./graphics.ts";
import { kLight, type Palette } from "./palette.ts";
import { stroke } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kPause = 150; // ms between drawings while robots move
const kFadeTime = 120; // run time after which a fading trail has gone [s]
const kShades = 4;
const kMostSegments = 60_000; // in one drawing; the newest of each robot
const kSlice = 0.6; // ms of a frame, where there are so many trails that one frame is not enough
const kFew = 150; // robots whose trails are drawn in one go

/** A drawing under way on the hidden canvas. */
interface Job {
  readonly trails: Iterator<[number, Trail]>;
  readonly camera: Camera;
  readonly most: number;
  readonly isFew: boolean;
}

/**
 * Draws on a hidden canvas, a slice with each frame where there is much to draw, and shows it when it is whole. Until
 * then what was drawn before is moved along with the camera.
 */
export class TrailLayer {
  private readonly hidden = document.createElement("canvas");
  private shown: Camera | null = null; // the camera of what is shown
  private job: Job | null = null;
  private finished = 0;

  constructor(readonly canvas: HTMLCanvasElement) {
    canvas.style.transformOrigin = "0 0";
  }

  isDue(model: Model): boolean {
    if (!model.get("map").layers.trails) return false;
    return this.job !== null || performance.now() - this.finished >= kPause;
  }

  get isPending(): boolean {
    return this.job !== null;
  }

  /** @param whole  now, whatever it takes */
  draw(camera: Camera, model: Model, palette: Palette, density: number, whole = false): void {
    const { layers } = model.get("map");
    this.canvas.style.display = layers.trails ? "" : "none";
    if (!layers.trails) {
      this.job = null;
      return;
    }
    if (!this.job || !isSameView(this.job.camera, camera)) this.begin(camera, model, density);
    const pen = this.pen(this.hidden, this.job!.camera, palette, density);
    if (this.advance(pen, model, whole)) this.show(density);
    else this.moveAlong(camera);
  }

  private begin(camera: Camera, model: Model, density: number): void {
    const robots = Math.max(1, model.get("roster").robots.length);
    this.hidden.width = Math.round(camera.width * density);
    this.hidden.height = Math.round(camera.height * density);
    this.job = {
      trails: model.trails[Symbol.iterator](),
      camera: camera.copy(),
      most: Math.max(8, Math.floor(kMostSegments / robots)),
      isFew: robots <= kFew,
    };
  }

  /** True: all are drawn. */
  private advance(pen: Pen, model: Model, whole: boolean): boolean {
    const { trails, most, isFew } = this.job!;
    const { trails: mode } = model.get("map");
    const roster = model.get("roster");
    const start = performance.now();
    for (;;) {
      const next = trails.next();
      if (next.done) return true;
      const [id, trail] = next.value;
      const color = colorOf(pen, roster.robot(id)?.color ?? "");
      if (mode === "stay") drawPart(pen, trail, Math.max(0, trail.count - most), trail.count, color, 0.6);
      else drawFading(pen, trail, most, color, model.time);
      if (!isFew && !whole && performance.now() - start > kSlice) return false;
    }
  }

  private show(density: number): void {
    const { camera } = this.job!;
    const { context } = this.pen(this.canvas, camera, kLight, density);
    context.clearRect(0, 0, camera.width, camera.height);
    context.drawImage(this.hidden, 0, 0, camera.width, camera.height);
    this.canvas.style.transform = "";
    this.shown = camera;
    this.job = null;
    this.finished = performance.now();
  }

  private moveAlong(camera: Camera): void {
    if (!this.shown) return;
    const zoom = camera.scale / this.shown.scale;
    const { x, y } = camera.toScreen(this.shown.toWorld({ x: 0, y: 0 }));
    this.canvas.style.transform = `matrix(${zoom},0,0,${zoom},${x},${y})`;
  }

  private pen(canvas: HTMLCanvasElement, camera: Camera, palette: Palette, density: number): Pen {
    const context = pen2d(canvas)!;
    context.setTransform(density, 0, 0, density, 0, 0);
    return { context, camera, palette, military: false, density };
  }
}

const kColors = new Map<string, string>();

function colorOf({ palette }: Pen, color: string): string {
  const key = `${palette.isDark}${color}`;
  let known = kColors.get(key);
  if (!known) {
    const wanted = parseColor(color) ?? parseColor(palette.softInk)!;
    known = toHex(readableOn(wanted, palette.groundRgb, palette.isDark ? 4 : 2));
    kColors.set(key, known);
  }
  return known;
}

function isSameView(a: Camera, b: Camera): boolean {
  return a.x === b.x && a.y === b.y && a.scale === b.scale && a.width === b.width && a.height === b.height;
}

function drawFading(pen: Pen, trail: Trail, most: number, color: string, now: number): void {
  let end = trail.count;
  for (let shade = 0; shade < kShades; ++shade) {
    const oldest = now - (kFadeTime * (shade + 1)) / kShades;
    let begin = end;
    while (begin > 0 && trail.count - begin < most && trail.time(begin - 1) >= oldest) --begin;
    drawPart(pen, trail, begin, Math.min(trail.count, end + 1), color, 0.75 * (1 - shade / kShades));
    end = begin;
  }
}

function drawPart(pen: Pen, trail: Trail, begin: number, end: number, color: string, opacity: number): void {
  const { context, camera } = pen;
  if (end - begin < 2) return;
  const seen = camera.visible();
  context.beginPath();
  let isDown = false;
  for (let i = begin; i < end; ++i) {
    const x = trail.x(i);
    const y = trail.y(i);
    if (i > begin) {
      const px = trail.x(i - 1);
      const py = trail.y(i - 1);
      const box = { xMin: Math.min(x, px), xMax: Math.max(x, px), yMin: Math.min(y, py), yMax: Math.max(y, py) };
      const isSeen = overlaps(grown(box), seen);
      if (isSeen && !isDown) context.moveTo(camera.toScreenX(px), camera.toScreenY(py));
      if (isSeen) context.lineTo(camera.toScreenX(x), camera.toScreenY(y));
      isDown = isSeen;
    }
  }
  context.globalAlpha = opacity;
  stroke(pen, { color, width: 1.75 });
  context.globalAlpha = 1;
}

/** A box without extent overlaps nothing. */
function grown(box: { xMin: number; yMin: number; xMax: number; yMax: number }) {
  return { xMin: box.xMin - 1e-6, yMin: box.yMin - 1e-6, xMax: box.xMax + 1e-6, yMax: box.yMax + 1e-6 };
}
