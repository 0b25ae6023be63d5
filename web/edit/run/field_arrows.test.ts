import { expect, test } from "vitest";
import { arrowLength, gridFor, readArrows } from "./field_arrows.ts";

test("arrows are read as they are sent, and half a one is none", () => {
  const bytes = new Uint8Array(40);
  const view = new DataView(bytes.buffer);
  [1, 2, 0.5, -0.5].forEach((value, i) => {
    view.setFloat32(4 * i, value, true);
  });
  expect(readArrows(bytes)).toEqual([
    { at: { x: 1, y: 2 }, way: { x: 0.5, y: -0.5 } },
    { at: { x: 0, y: 0 }, way: { x: 0, y: 0 } },
  ]);
});

test("the grid covers what is in sight of the area, at most a hundred each way", () => {
  const grid = gridFor({ xMin: -10, yMin: 20, xMax: 200, yMax: 60 }, { width: 100, height: 50 }, 2.6);
  expect(grid.area).toEqual({ xMin: 0, yMin: 20, xMax: 100, yMax: 50 });
  expect([grid.columns, grid.rows]).toEqual([10, 3]);
  const close = gridFor({ xMin: 0, yMin: 0, xMax: 100, yMax: 50 }, { width: 100, height: 50 }, 1000);
  expect([close.columns, close.rows]).toEqual([100, 100]);
  const away = gridFor({ xMin: 300, yMin: 300, xMax: 400, yMax: 400 }, { width: 100, height: 50 }, 10);
  expect(away.columns).toBe(0);
});

test("an arrow stays within its place", () => {
  expect(arrowLength(0, 20)).toBe(0);
  expect(arrowLength(0.5, 20)).toBe(9);
  expect(arrowLength(7, 20)).toBe(18);
  expect(arrowLength(Number.NaN, 20)).toBe(0);
});
