import { expect, test } from "vitest";
import { boundsOf, holdsAll } from "./view.ts";

const node = (x: number, y: number) => ({ position: { x, y }, width: 100, height: 50 });

test("a page is seen as a whole as long as nothing of it is outside", () => {
  const bounds = boundsOf([node(0, 0), node(300, 200)]);
  expect(bounds).toEqual({ x: 0, y: 0, width: 400, height: 250 });
  expect(holdsAll({ x: -10, y: -10, width: 500, height: 300 }, bounds)).toBe(true);
  expect(holdsAll({ x: 10, y: -10, width: 500, height: 300 }, bounds)).toBe(false);
  expect(holdsAll({ x: -10, y: -10, width: 405, height: 300 }, bounds)).toBe(false);
  expect(holdsAll({ x: 0, y: 0, width: 1, height: 1 }, boundsOf([]))).toBe(true);
});
