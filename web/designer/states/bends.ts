// How far each transition is bent aside, so that it passes no other state and its label lies on nothing. Greedy, in the
// order of the text, so that small changes move little.
import { type Curve, curveBetween, loopAt, type Point, type Rect } from "./curve.ts";

export interface Way {
  from: string;
  to: string;
  /** Of its label [px]. */
  labelWidth: number;
}

const kStep = 22; // [px]
const kMostSteps = 9;
const kLabelHeight = 24;

/** For each way how far its middle is aside of the straight one, seen from the state that comes first by name [px]; of a loop its place. */
export function bendsOf(ways: readonly Way[], rects: ReadonlyMap<string, Rect>): number[] {
  const labels: Rect[] = [];
  const loops = new Map<string, number>();
  return ways.map((way) => {
    const from = rects.get(way.from);
    const to = rects.get(way.to);
    if (!from || !to) return 0;
    if (way.from === way.to) {
      const place = loops.get(way.from) ?? 0;
      loops.set(way.from, place + 1);
      labels.push(labelRect(loopAt(from, place).middle, way.labelWidth));
      return place;
    }
    const others = [...rects].filter(([name]) => name !== way.from && name !== way.to).map(([, rect]) => rect);
    let best = 0;
    let least = Number.POSITIVE_INFINITY;
    for (const bend of candidates()) {
      const curve = curveBetween(from, to, bend, way.from > way.to);
      const label = labelRect(curve.middle, way.labelWidth);
      const cost =
        Math.abs(bend) * 0.02 +
        10 * others.filter((rect) => passes(curve, rect)).length +
        6 * labels.filter((one) => isOver(one, label)).length +
        8 * [...rects.values()].filter((rect) => isOver(rect, label)).length;
      if (cost < least) [best, least] = [bend, cost];
      if (least < 1) break;
    }
    labels.push(labelRect(curveBetween(from, to, best, way.from > way.to).middle, way.labelWidth));
    return best;
  });
}

/** 0, a little to each side, more ... */
function candidates(): number[] {
  const bends = [0];
  for (let i = 1; i <= kMostSteps; ++i) bends.push(i * kStep, -i * kStep);
  return bends;
}

function passes(curve: Curve, rect: Rect): boolean {
  for (let i = 1; i < 16; ++i) {
    const at = pointOf(curve, i / 16);
    if (at.x > rect.x - 8 && at.x < rect.x + rect.width + 8 && at.y > rect.y - 8 && at.y < rect.y + rect.height + 8) {
      return true;
    }
  }
  return false;
}

function pointOf({ begin, control, end }: Curve, t: number): Point {
  const u = 1 - t;
  return {
    x: u * u * begin.x + 2 * u * t * control.x + t * t * end.x,
    y: u * u * begin.y + 2 * u * t * control.y + t * t * end.y,
  };
}

function labelRect(middle: Point, width: number): Rect {
  return { x: middle.x - width / 2, y: middle.y - kLabelHeight / 2, width, height: kLabelHeight };
}

function isOver(a: Rect, b: Rect): boolean {
  return a.x < b.x + b.width + 4 && b.x < a.x + a.width + 4 && a.y < b.y + b.height + 2 && b.y < a.y + a.height + 2;
}
