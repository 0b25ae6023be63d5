// Where robots have been: lines in their colours, which stay or fade.
import { parseColor, readableOn, toHex } from "../color.ts";
import { overlaps } from "../geometry.ts";
import type { Model } from "../model.ts";
import type { Trail } from "../trails.ts";
import { stroke } from "./strokes.ts";
import type { Pen } from "./tool.ts";

const kPause = 100; // ms between drawings while robots move
const kFadeTime = 120; // run time after which a fading trail has gone [s]
const kShades = 4;
const kMostSegments = 60_000; // in one drawing; the newest of each robot

export class TrailLayer {
  private drawn = 0;
  private cost = 0;

  constructor(readonly canvas: HTMLCanvasElement) {}

  /** Where drawing takes long, it is done less often: at most a tenth of the time goes into it. */
  isDue(model: Model): boolean {
    return model.get("map").layers.trails && performance.now() - this.drawn >= Math.max(kPause, this.cost * 10);
  }

  draw(pen: Pen, model: Model): void {
    const { layers, trails: mode } = model.get("map");
    this.canvas.style.display = layers.trails ? "" : "none";
    if (!layers.trails) return;
    const start = performance.now();
    const roster = model.get("roster");
    const most = Math.max(8, Math.floor(kMostSegments / Math.max(1, roster.robots.length)));
    for (const [id, trail] of model.trails) {
      const color = parseColor(roster.robot(id)?.color ?? "") ?? parseColor(pen.palette.softInk)!;
      const shown = toHex(readableOn(color, pen.palette.groundRgb, pen.palette.isDark ? 4 : 2));
      if (mode === "stay") drawPart(pen, trail, Math.max(0, trail.count - most), trail.count, shown, 0.6);
      else drawFading(pen, trail, most, shown, model.time);
    }
    this.drawn = performance.now();
    this.cost = this.drawn - start;
  }
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
