// The ways of transitions, and where on its way each label stands: so that no way passes another state, and no label lies
// on a state, on another label or on another way. Each is tried against all others, in the order of the text and again
// until nothing gets better: small changes move little, and the same page is drawn the same.
import { type Curve, curveBetween, loopAt, type Point, type Rect } from "./curve.ts";
import { contains, crosses, enlargedRect, isOver, pathOf } from "./geometry.ts";
import type { LabelSize } from "./label.ts";

export interface StatePair {
  from: string;
  to: string;
}

/** Of a way's label: as it is best, and cut short where there is no room for that [px]. */
export interface LabelSizes {
  label: LabelSize;
  short: LabelSize;
}

export interface Route {
  /** How far the middle of the way is aside of the straight one, seen from the state that comes first by name [px]; of a loop its place. */
  bend: number;
  /** Where on the way its label stands, 0 .. 1. */
  at: number;
  isShort: boolean;
}

const kStep = 24; // [px]
const kMostSteps = 11;
const kPlaces = [0.5, 0.43, 0.57, 0.36, 0.64, 0.29, 0.71, 0.22, 0.78];
const kLoops = [0, 1, -1, 2, -2, 3, -3];
/** How thoroughly it is looked for, by the number of ways: the work grows with its square. */
const kThoroughness = [
  { ways: 100, rounds: 5, steps: kMostSteps },
  { ways: 200, rounds: 1, steps: 6 },
  { ways: Number.POSITIVE_INFINITY, rounds: 0, steps: 2 },
];
const kGap = 5; // between a label and anything else [px]
const kArrow = 14; // a label leaves this much of the arrow's end free [px]
const kClear = 8; // a way keeps this far from other states [px]

/** What is wrong with a route, in order of how bad it is. */
const kCost = { onState: 100, onLabel: 100, onWay: 60, passes: 80, together: 50, onArrow: 40, short: 30 };

/** A way that might be taken. */
interface Candidate {
  bend: number;
  curve: Curve;
  points: readonly Point[];
  /** Where its label may stand, by kPlaces. */
  middles: readonly Point[];
  box: Rect;
  /** Without any label. */
  cost: number;
}
interface ChosenRoute {
  drawn: Candidate;
  label: Rect;
  route: Route;
}

export interface Routes {
  routes: Route[];
  /** How much lies on something all the same; 0: nothing. */
  trouble: number;
}

/** Of one page: what ways could be taken is worked out once, for labels of any size. */
export class Router {
  private readonly tried: (readonly Candidate[])[];
  private readonly states: readonly Rect[];
  private readonly bounds: Rect;
  private readonly thoroughness: { rounds: number; steps: number };
  private labels: readonly LabelSizes[] = [];
  private taken: (ChosenRoute | undefined)[] = [];

  constructor(
    private readonly ways: readonly StatePair[],
    private readonly rects: ReadonlyMap<string, Rect>,
  ) {
    this.states = [...rects.values()];
    this.bounds = enlargedRect(boundsOf(this.states), 60);
    this.thoroughness = kThoroughness.find((one) => ways.length <= one.ways)!;
    this.tried = ways.map((way) => this.candidates(way));
  }

  /** `labels`: one for each way. `restarts`: how often all begin anew, at most. */
  run(labels: readonly LabelSizes[], restarts: number): Routes {
    this.labels = labels;
    let order = [...this.ways.keys()];
    let best: { taken: (ChosenRoute | undefined)[]; trouble: number } | undefined;
    for (let attempt = 0; attempt <= restarts; ++attempt) {
      const troubles = this.chooseInOrder(order);
      const trouble = troubles.reduce((sum, one) => sum + one, 0);
      if (!best || trouble < best.trouble) best = { taken: this.taken, trouble };
      if (trouble === 0) break;
      order = [...order.filter((i) => troubles[i]! > 0), ...order.filter((i) => troubles[i] === 0)];
    }
    this.taken = best!.taken;
    return {
      routes: this.taken.map((one) => one?.route ?? { bend: 0, at: 0.5, isShort: false }),
      trouble: best!.trouble,
    };
  }

  /** All anew, and again until nothing gets better. @returns how much of each lies on something */
  private chooseInOrder(order: readonly number[]): number[] {
    this.taken = this.ways.map(() => undefined);
    for (const i of order) this.choose(i);
    for (let round = 0; round < this.thoroughness.rounds; ++round) {
      let isBetter = false;
      for (const i of order) {
        if (this.taken[i] && this.troubles(i, this.taken[i]!) > 0) isBetter = this.choose(i) || isBetter;
      }
      if (!isBetter) break;
    }
    return this.taken.map((one, i) => (one ? this.hardTrouble(i, one) : 0));
  }

  private candidates(way: StatePair): Candidate[] {
    const from = this.rects.get(way.from);
    const to = this.rects.get(way.to);
    if (!from || !to) return [];
    const isLoop = way.from === way.to;
    const others = [...this.rects]
      .filter(([name]) => name !== way.from && name !== way.to)
      .map(([, rect]) => enlargedRect(rect, kClear));
    const bends = isLoop ? kLoops : kBends.slice(0, 1 + 2 * this.thoroughness.steps);
    return bends.map((bend, order) => {
      const curve = isLoop ? loopAt(from, bend) : curveBetween(from, to, bend, way.from > way.to);
      const points = pathOf(curve);
      const box = boundsOf(points.map(({ x, y }) => ({ x, y, width: 0, height: 0 })));
      const passed = others.filter((rect) => isOver(rect, box) && crosses(points, rect)).length;
      const middles = (isLoop ? [0.5] : kPlaces).map((at) => curve.pointAt(at));
      const strays = outside(box, this.bounds);
      const cost = kCost.passes * passed + (isLoop ? 2 * order : Math.abs(bend) * 0.03) + strays * 0.05;
      return { bend, curve, points, middles, box, cost };
    });
  }

  /** Takes the best route for a way, all others as they are. @returns whether it is another one than before */
  private choose(i: number): boolean {
    const before = this.taken[i];
    const best = this.best(i);
    this.taken[i] = best;
    return best !== undefined && !isSameRoute(best.route, before?.route);
  }

  private best(i: number): ChosenRoute | undefined {
    let best: ChosenRoute | undefined;
    let least = Number.POSITIVE_INFINITY;
    for (const drawn of this.tried[i]!) {
      if (drawn.cost >= least) continue;
      const base = drawn.cost + this.costOfWay(i, drawn);
      for (const { at, isShort, middle, size, aside, shortened } of placings(drawn, this.labels[i]!)) {
        const extra = base + aside + shortened;
        if (extra >= least) continue;
        const label = around(middle, size);
        const cost = extra + this.costOfLabel(i, drawn, label, least - extra);
        if (cost >= least) continue;
        least = cost;
        best = { drawn, label, route: { bend: drawn.bend, at, isShort } };
      }
    }
    return best;
  }

  /** Without what is only less beautiful. */
  private hardTrouble(i: number, { drawn, label }: ChosenRoute): number {
    const cost = this.costOfWay(i, drawn) + this.costOfLabel(i, drawn, label) - this.strayCost(label);
    return cost < kCost.onArrow ? 0 : cost;
  }

  private strayCost(label: Rect): number {
    return outside(label, this.bounds) * 0.3;
  }

  /** What would be wrong that can be seen: of the way and of its label. */
  private troubles(i: number, { drawn, label, route }: ChosenRoute): number {
    return this.costOfWay(i, drawn) + this.costOfLabel(i, drawn, label) + (route.isShort ? kCost.short : 0);
  }

  private costOfWay(i: number, drawn: Candidate): number {
    const way = this.ways[i]!;
    let cost = 0;
    this.taken.forEach((other, j) => {
      if (!other || j === i) return;
      if (isOver(other.label, drawn.box, kGap) && crosses(drawn.points, enlargedRect(other.label, kGap)))
        cost += kCost.onWay;
      const with_ = this.ways[j]!;
      const isSame = way.from === with_.from && way.to === with_.to;
      const isBack = way.from === with_.to && way.to === with_.from;
      if ((isSame || isBack) && Math.abs(drawn.bend - other.drawn.bend) < (way.from === way.to ? 1 : kStep))
        cost += kCost.together;
    });
    return cost;
  }

  /** At least `enough` where it is that much or more: what is left is not looked at. */
  private costOfLabel(i: number, drawn: Candidate, label: Rect, enough = Number.POSITIVE_INFINITY): number {
    let cost = this.strayCost(label);
    for (const state of this.states) if (isOver(state, label, kGap)) cost += kCost.onState;
    if (this.ways[i]!.from !== this.ways[i]!.to && contains(enlargedRect(label, kArrow), drawn.curve.end))
      cost += kCost.onArrow;
    const roomy = enlargedRect(label, kGap);
    for (let j = 0; j < this.taken.length && cost < enough; ++j) {
      const other = this.taken[j];
      if (!other || j === i) continue;
      if (isOver(other.label, label, kGap)) cost += kCost.onLabel;
      if (isOver(other.drawn.box, label, kGap) && crosses(other.drawn.points, roomy)) cost += kCost.onWay;
    }
    return cost;
  }
}

/** Where on its way a label may stand, whole or short, the most beautiful first. */
function placings({ middles }: Candidate, { label, short }: LabelSizes) {
  return [false, true].flatMap((isShort) =>
    middles.map((middle, place) => {
      const at = kPlaces[place]!;
      const [aside, shortened] = [Math.abs(at - 0.5) * 6, isShort ? kCost.short : 0];
      return { at, isShort, middle, size: isShort ? short : label, aside, shortened };
    }),
  );
}

function isSameRoute(a: Route, b: Route | undefined): boolean {
  return a.bend === b?.bend && a.at === b.at && a.isShort === b.isShort;
}

/** 0, a little to each side, more ... */
const kBends: readonly number[] = [0, ...Array.from({ length: kMostSteps }, (_, i) => (i + 1) * kStep)].flatMap(
  (bend) => (bend === 0 ? [0] : [bend, -bend]),
);

function around(middle: Point, size: LabelSize): Rect {
  return { x: middle.x - size.width / 2, y: middle.y - size.height / 2, ...size };
}

/** How far it reaches out of the other one [px]. */
function outside(rect: Rect, of: Rect): number {
  return (
    Math.max(0, of.x - rect.x) +
    Math.max(0, of.y - rect.y) +
    Math.max(0, rect.x + rect.width - of.x - of.width) +
    Math.max(0, rect.y + rect.height - of.y - of.height)
  );
}

function boundsOf(rects: readonly Rect[]): Rect {
  if (rects.length === 0) return { x: 0, y: 0, width: 0, height: 0 };
  const x = Math.min(...rects.map((rect) => rect.x));
  const y = Math.min(...rects.map((rect) => rect.y));
  const right = Math.max(...rects.map((rect) => rect.x + rect.width));
  const bottom = Math.max(...rects.map((rect) => rect.y + rect.height));
  return { x, y, width: right - x, height: bottom - y };
}
