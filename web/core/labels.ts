// Puts names where they hide nothing and no other name: each has places where it may stand, the best first.
import { type Box, overlaps, type Point } from "./geometry.ts";

export interface LabelWish<Key> {
  readonly key: Key;
  readonly width: number;
  readonly height: number;
  /** Where its middle may be. */
  readonly places: readonly Point[];
  /** Who has more chooses first. */
  readonly weight: number;
  /** What the name would hide there: the least is taken, the earlier place of two alike. Without it the first. */
  readonly cost?: (box: Box) => number;
}

export interface LabelPlace<Key> {
  readonly key: Key;
  readonly box: Box;
  readonly middle: Point;
}

const kCell = 64;

/** Boxes that are taken, found by cells. */
export class TakenBoxes {
  private readonly cells = new Map<number, Box[]>();

  constructor(boxes: readonly Box[] = []) {
    for (const box of boxes) this.take(box);
  }

  isFree(box: Box): boolean {
    return !this.cellsOf(box).some((cell) => this.cells.get(cell)?.some((other) => overlaps(box, other)));
  }

  take(box: Box): void {
    for (const cell of this.cellsOf(box)) {
      const known = this.cells.get(cell);
      if (known) known.push(box);
      else this.cells.set(cell, [box]);
    }
  }

  private cellsOf(box: Box): number[] {
    const cells: number[] = [];
    for (let y = Math.floor(box.yMin / kCell); y <= Math.floor(box.yMax / kCell); ++y) {
      for (let x = Math.floor(box.xMin / kCell); x <= Math.floor(box.xMax / kCell); ++x) cells.push(y * 65536 + x);
    }
    return cells;
  }
}

/** Labels that find no free place within the screen are left out. */
export function placeLabels<Key>(wishes: readonly LabelWish<Key>[], taken: TakenBoxes, screen: Box): LabelPlace<Key>[] {
  const order = wishes.map((_, index) => index).sort((a, b) => wishes[b]!.weight - wishes[a]!.weight || a - b);
  const placed: LabelPlace<Key>[] = [];
  for (const index of order) {
    const best = bestPlace(wishes[index]!, taken, screen);
    if (!best) continue;
    taken.take(best.box);
    placed.push(best);
  }
  return placed;
}

function bestPlace<Key>(wish: LabelWish<Key>, taken: TakenBoxes, screen: Box): LabelPlace<Key> | null {
  let best: LabelPlace<Key> | null = null;
  let least = Infinity;
  for (const middle of wish.places) {
    const box = boxAround(middle, wish.width, wish.height);
    if (!isWithin(box, screen) || !taken.isFree(box)) continue;
    const cost = wish.cost?.(box) ?? 0;
    if (cost >= least) continue;
    least = cost;
    best = { key: wish.key, box, middle };
    if (cost === 0) break;
  }
  return best;
}

/**
 * Things that stand so close that no line of text fits between them, in groups; their order stays.
 *
 * @param height  of a line, and what stands beside each other is closer than three of it [px]
 */
export function clustersOf<Thing extends Point>(things: readonly Thing[], height = 13): Thing[][] {
  const groups: Thing[][] = [];
  for (const thing of things) {
    const isNear = (other: Thing): boolean =>
      Math.abs(thing.y - other.y) < height && Math.abs(thing.x - other.x) < 3 * height;
    const near = groups.filter((group) => group.some(isNear));
    const merged = [...near.flat(), thing];
    if (near.length === 0) groups.push(merged);
    else groups.splice(groups.indexOf(near[0]!), 1, merged);
    for (const group of near.slice(1)) groups.splice(groups.indexOf(group), 1);
  }
  return groups;
}

export function boxAround(middle: Point, width: number, height: number): Box {
  return {
    xMin: middle.x - width / 2,
    yMin: middle.y - height / 2,
    xMax: middle.x + width / 2,
    yMax: middle.y + height / 2,
  };
}

function isWithin(box: Box, screen: Box): boolean {
  return box.xMin >= screen.xMin && box.yMin >= screen.yMin && box.xMax <= screen.xMax && box.yMax <= screen.yMax;
}
