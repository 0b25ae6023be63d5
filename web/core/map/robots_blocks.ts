// Many robots without a graphics card: small pictures of each heading and colour, copied pixel by pixel into one image,
// which is several times faster than paths.
import type { Camera } from "../camera.ts";
import type { RobotTable } from "../robots.ts";
import type { Palette } from "./palette.ts";
import { kRobotShape, type RobotStyles } from "./robot_styles.ts";

const kHeadings = 64;
const kMostPixels = 64; // a larger robot is drawn by a path

/** What is not empty of a picture, pixel by pixel. */
interface Stamp {
  readonly side: number;
  readonly columns: Uint8Array;
  readonly rows: Uint8Array;
  /** From the upper left corner, in an image of the width that the stamp was made for. */
  readonly offsets: Int32Array;
  readonly colors: Uint32Array;
}

export class BlockPainter {
  private image: ImageData | null = null;
  private words = new Uint32Array(0);
  private readonly stamps = new Map<number, Stamp>();
  private stampsFor = "";

  /** Fills the whole canvas of `context`. */
  draw(
    context: CanvasRenderingContext2D,
    camera: Camera,
    robots: RobotTable,
    styles: RobotStyles,
    palette: Palette,
    density: number,
  ): void {
    const { width, height } = context.canvas;
    this.prepare(width, height);
    const scale = camera.scale * density;
    const left = width / 2 - camera.x * scale;
    const top = height / 2 + camera.y * scale;
    const key = `${palette.isDark}/${density}/${width}`;
    if (key !== this.stampsFor || this.stamps.size > 20_000) {
      this.stamps.clear();
      this.stampsFor = key;
    }
    for (let row = 0; row < robots.count; ++row) {
      const x = robots.x(row) * scale + left;
      const y = top - robots.y(row) * scale;
      if (!(x > -40 && y > -40 && x < width + 40 && y < height + 40)) continue;
      const id = Math.min(robots.id(row), styles.capacity - 1);
      const pixels = Math.min(kMostPixels, Math.round(styles.pixels(id, camera.scale) * density));
      const heading = Math.round((robots.heading(row) / (2 * Math.PI)) * kHeadings) % kHeadings;
      const at = id * 4;
      const color = (styles.colors[at + 2]! << 16) | (styles.colors[at + 1]! << 8) | styles.colors[at]!;
      const stamp = this.stamp(color, pixels, heading, styles.colors[at + 3]! > 0, palette, width);
      this.put(stamp, Math.round(x - stamp.side / 2), Math.round(y - stamp.side / 2), width, height);
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.putImageData(this.image!, 0, 0);
  }

  private prepare(width: number, height: number): void {
    if (this.image?.width !== width || this.image.height !== height) {
      this.image = new ImageData(width, height);
      this.words = new Uint32Array(this.image.data.buffer);
    } else {
      this.words.fill(0);
    }
  }

  private put(stamp: Stamp, left: number, top: number, width: number, height: number): void {
    const { side, columns, rows, offsets, colors } = stamp;
    const { words } = this;
    const isWhole = left >= 0 && top >= 0 && left + side <= width && top + side <= height;
    const corner = top * width + left;
    for (let i = 0; i < colors.length; ++i) {
      if (!isWhole) {
        const x = left + columns[i]!;
        const y = top + rows[i]!;
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
      }
      const to = corner + offsets[i]!;
      const color = colors[i]!;
      // Half-covered pixels give way to what is there: an edge over another robot is not seen at this size.
      if (color >>> 24 > 127 || words[to] === 0) words[to] = color;
    }
  }

  private stamp(
    color: number,
    pixels: number,
    heading: number,
    isSelected: boolean,
    palette: Palette,
    width: number,
  ): Stamp {
    // Exact in a double: 24 + 7 + 6 + 1 bits.
    const key = ((color * 128 + pixels) * kHeadings + heading) * 2 + (isSelected ? 1 : 0);
    let stamp = this.stamps.get(key);
    if (!stamp) {
      stamp = makeStamp(color, pixels, (heading / kHeadings) * 2 * Math.PI, isSelected, palette, width);
      this.stamps.set(key, stamp);
    }
    return stamp;
  }
}

function makeStamp(
  color: number,
  length: number,
  heading: number,
  isSelected: boolean,
  palette: Palette,
  width: number,
): Stamp {
  const ring = isSelected ? length * 0.62 + 3.5 : 0;
  const side = Math.ceil(Math.max(length * 1.24, ring * 2) + 5);
  const canvas = document.createElement("canvas");
  canvas.width = side;
  canvas.height = side;
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.translate(side / 2, side / 2);
  context.beginPath();
  for (const [ahead, left] of kRobotShape) {
    const x = (ahead * Math.cos(heading) - left * Math.sin(heading)) * length;
    const y = -(ahead * Math.sin(heading) + left * Math.cos(heading)) * length;
    context.lineTo(x, y);
  }
  context.closePath();
  context.lineJoin = "round";
  context.strokeStyle = palette.halo;
  context.lineWidth = 1.5;
  context.stroke();
  context.fillStyle = `rgb(${color & 255} ${(color >> 8) & 255} ${color >> 16})`;
  context.fill();
  if (isSelected) {
    context.beginPath();
    context.arc(0, 0, ring, 0, 2 * Math.PI);
    context.strokeStyle = palette.selection;
    context.lineWidth = 2;
    context.stroke();
  }
  const { data } = context.getImageData(0, 0, side, side);
  return cut(new Uint32Array(data.buffer), side, width);
}

function cut(pixels: Uint32Array, side: number, width: number): Stamp {
  const used = [...pixels.keys()].filter((at) => pixels[at]! >>> 24 > 0);
  return {
    side,
    columns: Uint8Array.from(used, (at) => at % side),
    rows: Uint8Array.from(used, (at) => Math.floor(at / side)),
    offsets: Int32Array.from(used, (at) => Math.floor(at / side) * width + (at % side)),
    colors: Uint32Array.from(used, (at) => pixels[at]!),
  };
}
