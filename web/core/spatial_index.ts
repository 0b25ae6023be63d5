// Finds what lies in a part of the plane without looking at everything: a grid of square cells.
import { type Box, overlaps, union } from "./geometry.ts";

/** Built once from all items; items are found by their boxes. */
export class SpatialIndex<Item> {
  private readonly cells = new Map<number, number[]>();
  private readonly size: number;
  private readonly origin: { x: number; y: number };
  private readonly columns: number;
  private readonly rows: number;

  constructor(private readonly items: readonly { readonly box: Box; readonly item: Item }[]) {
    const whole = items.reduce<Box | null>((sum, { box }) => (sum ? union(sum, box) : box), null);
    const { xMin, yMin, xMax, yMax } = whole ?? { xMin: 0, yMin: 0, xMax: 1, yMax: 1 };
    this.origin = { x: xMin, y: yMin };
    const side = Math.max(1, Math.min(128, Math.ceil(Math.sqrt(items.length))));
    this.size = Math.max(xMax - xMin, yMax - yMin, 1e-9) / side;
    this.columns = Math.floor((xMax - xMin) / this.size) + 1;
    this.rows = Math.floor((yMax - yMin) / this.size) + 1;
    items.forEach(({ box }, index) => {
      this.forCells(box, (cell) => {
        const known = this.cells.get(cell);
        if (known) known.push(index);
        else this.cells.set(cell, [index]);
      });
    });
  }

  /** Everything whose box touches this one, in the order in which it was given. */
  within(box: Box): Item[] {
    const found = new Set<number>();
    this.forCells(box, (cell) => {
      for (const index of this.cells.get(cell) ?? []) {
        const own = this.items[index]!.box;
        if (overlaps(own, box) || touches(own, box)) found.add(index);
      }
    });
    return [...found].sort((a, b) => a - b).map((index) => this.items[index]!.item);
  }

  private forCells(box: Box, act: (cell: number) => void): void {
    const cell = (value: number, origin: number, most: number): number =>
      Math.max(0, Math.min(most - 1, Math.floor((value - origin) / this.size)));
    const left = cell(box.xMin, this.origin.x, this.columns);
    const right = cell(box.xMax, this.origin.x, this.columns);
    const low = cell(box.yMin, this.origin.y, this.rows);
    const high = cell(box.yMax, this.origin.y, this.rows);
    for (let row = low; row <= high; ++row) {
      for (let column = left; column <= right; ++column) act(row * this.columns + column);
    }
  }
}

function touches(a: Box, b: Box): boolean {
  return a.xMin <= b.xMax && b.xMin <= a.xMax && a.yMin <= b.yMax && b.yMin <= a.yMax;
}
