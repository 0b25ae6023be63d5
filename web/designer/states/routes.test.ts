import fc from "fast-check";
import { expect, test } from "vitest";
import { curveBetween, loopAt, type Rect } from "./curve.ts";
import { crosses, isOver, pathOf } from "./geometry.ts";
import { type StatePair as Ends, type LabelSizes, type Route, Router } from "./routes.ts";

type Way = Ends & LabelSizes;

const routesOf = (ways: readonly Way[], rects: ReadonlyMap<string, Rect>, restarts = 0) =>
  new Router(ways, rects).run(ways, restarts);
const box = (x: number, y: number) => ({ x, y, width: 128, height: 64 });
const way = (from: string, to: string, width = 120): Way => ({
  from,
  to,
  label: { width, height: 24 },
  short: { width: Math.min(width, 90), height: 24 },
});

interface Drawn {
  label: Rect;
  points: ReturnType<typeof pathOf>;
}

function drawn(ways: readonly Way[], rects: ReadonlyMap<string, Rect>, routes: readonly Route[]): Drawn[] {
  return ways.map(({ from, to, label, short }, i) => {
    const route = routes[i]!;
    const curve =
      from === to
        ? loopAt(rects.get(from)!, route.bend)
        : curveBetween(rects.get(from)!, rects.get(to)!, route.bend, from > to);
    const size = route.isShort ? short : label;
    const middle = curve.pointAt(route.at);
    return {
      label: { x: middle.x - size.width / 2, y: middle.y - size.height / 2, ...size },
      points: pathOf(curve),
    };
  });
}

/** How many labels lie on a state, on another label or on another way. */
function troubles(ways: readonly Way[], rects: ReadonlyMap<string, Rect>): number {
  const all = drawn(ways, rects, routesOf(ways, rects).routes);
  let count = 0;
  all.forEach(({ label }, i) => {
    for (const state of rects.values()) if (isOver(label, state)) ++count;
    all.forEach((other, j) => {
      if (i !== j && (isOver(label, other.label) || crosses(other.points, label))) ++count;
    });
  });
  return count;
}

test("there and back do not lie on each other", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(400, 0)],
  ]);
  const ways = [way("A", "B"), way("B", "A")];
  expect(troubles(ways, rects)).toBe(0);
  const [there, back] = routesOf(ways, rects).routes;
  expect(Math.abs(there!.bend - back!.bend)).toBeGreaterThanOrEqual(24);
});

test("a transition goes round a state that stands between", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(300, 0)],
    ["C", box(600, 0)],
  ]);
  const ways = [way("A", "C", 60)];
  const [route] = routesOf(ways, rects).routes;
  expect(Math.abs(route!.bend)).toBeGreaterThan(30);
  const [line] = drawn(ways, rects, [route!]);
  expect(crosses(line!.points, rects.get("B")!)).toBe(false);
});

test("ways that cross leave each other's labels free", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(500, 400)],
    ["C", box(500, 0)],
    ["D", box(0, 400)],
  ]);
  expect(troubles([way("A", "B", 200), way("C", "D", 200), way("A", "C", 200), way("D", "B", 200)], rects)).toBe(0);
});

test("a label that has no room is cut short before it lies on something", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(240, 0)],
    ["over", { x: -200, y: -330, width: 800, height: 300 }],
    ["under", { x: -200, y: 96, width: 800, height: 300 }],
  ]);
  const [route] = routesOf([way("A", "B", 200)], rects).routes;
  expect(route!.isShort).toBe(true);
});

test("several loops, triples and a ring are drawn without a label on anything", () => {
  const rects = new Map([
    ["A", box(0, 0)],
    ["B", box(420, 0)],
    ["C", box(420, 320)],
    ["D", box(0, 320)],
  ]);
  const ring = [way("A", "B"), way("B", "C"), way("C", "D"), way("D", "A"), way("A", "C"), way("B", "D")];
  expect(troubles([...ring, way("A", "A"), way("A", "A"), way("B", "A"), way("A", "B")], rects)).toBe(0);
});

test("the same page is drawn the same, whatever stands on it", () => {
  const name = fc.constantFrom("A", "B", "C", "D", "E");
  const place = fc.record({ x: fc.integer({ min: -900, max: 900 }), y: fc.integer({ min: -900, max: 900 }) });
  fc.assert(
    fc.property(
      fc.array(fc.tuple(name, place), { maxLength: 5 }),
      fc.array(fc.tuple(name, name), { maxLength: 9 }),
      (states, pairs) => {
        const rects = new Map(states.map(([one, { x, y }]) => [one, box(x, y)]));
        const ways = pairs.map(([from, to]) => way(from, to));
        const { routes, trouble } = routesOf(ways, rects);
        expect({ routes, trouble }).toEqual(routesOf(ways, rects));
        expect(routes).toHaveLength(ways.length);
        for (const { bend, at } of routes) {
          expect(Number.isFinite(bend)).toBe(true);
          expect(at).toBeGreaterThan(0);
          expect(at).toBeLessThan(1);
        }
      },
    ),
    { numRuns: 40 },
  );
});

test("where room is scarce, those that found none choose first when all begin anew", () => {
  const rects = new Map(
    [..."ABCDE"].map((name, i) => [name, box((i % 3) * 320, Math.floor(i / 3) * 200)] as [string, Rect]),
  );
  const ways = "AE BD AC CA ED BA AD CD BE EA EC DB".split(" ").map(([from, to]) => way(from!, to!, 160));
  expect(routesOf(ways, rects).trouble).toBeGreaterThan(0);
  expect(routesOf(ways, rects, 12).trouble).toBe(0);
});
