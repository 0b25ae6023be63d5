// How each robot looks, by its id: found once when the roster, the selection or a setting changes, not in each frame.
import { parseColor, readableOn } from "../color.ts";
import type { Model } from "../model.ts";
import { paletteOf } from "./palette.ts";

export const kTableWidth = 256; // robots a row, as in the graphics card's table

export class RobotStyles {
  /** Ids below this have a style. */
  capacity = 0;
  /** red, green, blue, 255 where the robot is selected else 0. */
  colors = new Uint8Array(0);
  /** Length of the drawing and radius of the body [m]. */
  sizes = new Float32Array(0);
  /** Least length of the drawing on the screen [CSS pixels]. */
  least = 10;
  /** Of all bodies [m]. */
  largestRadius = 0;
  hasSelected = false;
  /** Grows with each change. */
  version = 0;
  private roster: unknown = null;
  private selection: unknown = null;
  private map: unknown = null;

  update(model: Model): void {
    const roster = model.get("roster");
    const selection = model.get("selection");
    const map = model.get("map");
    if (roster === this.roster && selection === this.selection && map === this.map) return;
    this.roster = roster;
    this.selection = selection;
    this.map = map;
    ++this.version;
    const most = roster.robots.reduce((largest, { id }) => Math.max(largest, id), 0);
    const rows = Math.ceil((Math.min(most, 1 << 20) + 1) / kTableWidth);
    this.capacity = rows * kTableWidth;
    this.colors = new Uint8Array(this.capacity * 4);
    this.sizes = new Float32Array(this.capacity * 2).fill(0.4);
    this.least = leastLength(roster.robots.length);
    this.hasSelected = selection.robots.length > 0;
    this.largestRadius = 0;
    const { groundRgb, idle, isDark } = paletteOf(map.theme);
    const unknown = parseColor(idle)!;
    for (let id = 0; id < this.capacity; ++id) this.setColor(id, unknown);
    const known = new Map<string, { r: number; g: number; b: number }>();
    for (const { id, color, radius, length } of roster.robots) {
      if (id >= this.capacity) continue;
      let shown = known.get(color);
      if (!shown) {
        shown = readableOn(parseColor(color) ?? unknown, groundRgb, isDark ? 4 : 2.8);
        known.set(color, shown);
      }
      this.setColor(id, shown);
      const body = radius > 0 ? radius : 0.2;
      this.sizes[id * 2] = Math.max(length, body * 2) * map.robotScale;
      this.sizes[id * 2 + 1] = body * map.robotScale;
      this.largestRadius = Math.max(this.largestRadius, body * map.robotScale);
    }
    for (const id of selection.robots) if (id < this.capacity) this.colors[id * 4 + 3] = 255;
  }

  /** The robot's length on a screen of that scale [CSS pixels]. */
  pixels(id: number, scale: number): number {
    return Math.max(this.least, (this.sizes[id * 2] ?? 0.4) * scale);
  }

  cssColor(id: number): string {
    const at = Math.min(id, this.capacity - 1) * 4;
    return `rgb(${this.colors[at]} ${this.colors[at + 1]} ${this.colors[at + 2]})`;
  }

  isSelected(id: number): boolean {
    return this.colors[id * 4 + 3] === 255;
  }

  private setColor(id: number, { r, g, b }: { r: number; g: number; b: number }): void {
    this.colors[id * 4] = r;
    this.colors[id * 4 + 1] = g;
    this.colors[id * 4 + 2] = b;
  }
}

/** Few robots are easy to see; of many each has to be small. */
export function leastLength(robots: number): number {
  if (robots <= 60) return 18;
  if (robots <= 400) return 13;
  if (robots <= 2000) return 9;
  return 7;
}

/** The shape, ahead to the right, its length 1: a notched arrow head. */
export const kRobotShape: readonly (readonly [number, number])[] = [
  [0.56, 0],
  [-0.44, 0.4],
  [-0.26, 0],
  [-0.44, -0.4],
];
