import { expect, test } from "vitest";
import type { Point } from "../../core/geometry.ts";
import type { MapView } from "../../core/map/map_view.ts";
import type { MapPointer } from "../../core/map/tool.ts";
import { StartsTool } from "./starts_tool.ts";

function begun() {
  let starts: readonly Point[] = [];
  let told = 0;
  const tool = new StartsTool({
    get: () => starts,
    set: (next) => {
      starts = next;
    },
    done: () => {
      told += 1;
    },
  });
  const camera = { toScreen: (p: Point) => p, toWorld: (p: Point) => p, width: 200, height: 100 };
  tool.start({ camera, redraw: () => {}, useTool: () => {} } as unknown as MapView);
  const at = (x: number, y: number) => ({ world: { x, y }, screen: { x, y } }) as unknown as MapPointer;
  return { tool, at, starts: () => starts, told: () => told };
}

test("a click sets a place, dragging moves it, a click on it takes it away", () => {
  const { tool, at, starts, told } = begun();
  tool.down(at(10.04, 20));
  tool.up();
  tool.down(at(50, 50));
  tool.up();
  expect(starts()).toEqual([
    { x: 10, y: 20 },
    { x: 50, y: 50 },
  ]);
  tool.down(at(12, 20));
  tool.move(at(80, 30), true);
  tool.up();
  expect(starts()[0]).toEqual({ x: 80, y: 30 });
  tool.down(at(50, 50));
  tool.up();
  expect(starts()).toEqual([{ x: 80, y: 30 }]);
  expect(told()).toBe(4);
});

test("a drag that is broken off was not", () => {
  const { tool, at, starts } = begun();
  tool.down(at(10, 10));
  tool.up();
  tool.down(at(10, 10));
  tool.move(at(90, 90), true);
  tool.cancel();
  expect(starts()).toEqual([{ x: 10, y: 10 }]);
});

test("keys do the same: Enter in the middle of the map, Delete the last", () => {
  const { tool, starts } = begun();
  const press = (key: string) => tool.key({ key } as KeyboardEvent);
  expect(press("Enter")).toBe(true);
  expect(starts()).toEqual([{ x: 100, y: 50 }]);
  expect(press("Delete")).toBe(true);
  expect(starts()).toEqual([]);
  expect(press("a")).toBe(false);
});
