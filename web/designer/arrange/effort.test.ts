import fc from "fast-check";
import { expect, test } from "vitest";
import { columnSpots } from "./columns.ts";
import { effortOf, methodFor } from "./effort.ts";
import type { LayoutGraph } from "./graph.ts";
import { gridSpots, mostReadable, snakeSpots } from "./grid.ts";

type Pair = readonly [number, number];

function graph(kind: LayoutGraph["kind"], count: number, pairs: readonly Pair[]): LayoutGraph {
  return {
    kind,
    nodes: Array.from({ length: count }, (_, i) => ({ id: `${i}`, width: 128, height: 64, inputs: [], outputY: 32 })),
    wires: pairs.map(([from, to]) => ({ from: `${from}`, to: `${to}`, port: "" })),
  };
}
const chain = (count: number) => Array.from({ length: count - 1 }, (_, i): Pair => [i, i + 1]);
const backToStart = (count: number) => Array.from({ length: count - 1 }, (_, i): Pair => [i + 1, 0]);

test("the effort of a page is its nodes and how many layers its wires span", () => {
  expect(effortOf(graph("dataflow", 4, chain(4)))).toBe(7);
  expect(effortOf(graph("dataflow", 4, [...chain(4), [0, 3]]))).toBe(10);
  expect(effortOf(graph("states", 4, [...chain(4), [3, 0]]))).toBe(10); // a way back spans as much as there is between
  expect(effortOf(graph("states", 2, [[0, 0]]))).toBe(2); // a loop spans nothing
});

test("small pages are laid out with care, large ones quickly, the largest by what is linear", () => {
  const hub = (count: number) => graph("states", count, [...chain(count), ...backToStart(count)]);
  expect([8, 40, 200].map((count) => methodFor(hub(count)))).toEqual(["careful", "quick", "snake"]);
  const shared = (count: number) =>
    graph("dataflow", count, [...chain(count), ...backToStart(count).map(([a, b]): Pair => [b, a])]);
  expect([20, 40, 200].map((count) => methodFor(shared(count)))).toEqual(["careful", "quick", "columns"]);
  expect(methodFor(graph("dataflow", 241, chain(241)))).toBe("columns");
  expect(methodFor(graph("grid", 500, []))).toBe("grid");
});

test("whatever leads wherever, there is an effort, and everything gets a place of its own", () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 30 }),
      fc.array(fc.tuple(fc.nat(29), fc.nat(29))),
      fc.constantFrom("dataflow" as const, "states" as const),
      (count, pairs, kind) => {
        const page = graph(kind, count, pairs); // some lead to nodes that are not there
        expect(effortOf(page)).toBeGreaterThanOrEqual(count);
        expect(effortOf(page)).toBeLessThanOrEqual(count + pairs.length * count);
        for (const spots of [columnSpots(page), snakeSpots(page), gridSpots(page)]) {
          expect(new Set(spots.map((one) => one.id)).size).toBe(count);
          expect(new Set(spots.map(({ x, y }) => `${x} ${y}`)).size).toBe(count);
        }
      },
    ),
  );
});

test("a snake goes to the right and back", () => {
  const spots = snakeSpots(graph("states", 5, chain(5)));
  const column = (x: number) => spots.findIndex((one) => one.x === x);
  expect(spots.map(({ x }) => column(x))).toEqual([0, 1, 2, 2, 1]);
  expect(new Set(spots.map(({ y }) => y)).size).toBe(2);
});

test("of two layouts the larger one in sight is taken; where neither can be read, the snake", () => {
  const page = graph("states", 30, chain(30));
  const across = page.nodes.map(({ id }, i) => ({ id, x: i * 100, y: 0 }));
  const down = page.nodes.map(({ id }, i) => ({ id, x: 0, y: i * 80 }));
  expect(mostReadable([across, down], page)).toBe(down);
  const far = across.map((spot) => ({ ...spot, x: spot.x * 10 }));
  expect(mostReadable([far], page)).toEqual(snakeSpots(page));
});
