import { expect, test } from "vitest";
import { boundsOf, holdsAll, readableView } from "./view.ts";

const node = (x: number, y: number) => ({ position: { x, y }, width: 100, height: 50 });

test("a page is seen as a whole as long as nothing of it is outside", () => {
  const bounds = boundsOf([node(0, 0), node(300, 200)]);
  expect(bounds).toEqual({ x: 0, y: 0, width: 400, height: 250 });
  expect(holdsAll({ x: -10, y: -10, width: 500, height: 300 }, bounds)).toBe(true);
  expect(holdsAll({ x: 10, y: -10, width: 500, height: 300 }, bounds)).toBe(false);
  expect(holdsAll({ x: -10, y: -10, width: 405, height: 300 }, bounds)).toBe(false);
  expect(holdsAll({ x: 0, y: 0, width: 1, height: 1 }, boundsOf([]))).toBe(true);
});

const screen = { width: 1280, height: 800 };
const page = { x: -100, y: -50, width: 900, height: 500 };

test("a page that can be read is shown as a whole", () => {
  const { x, y, zoom } = readableView(page, { width: 760, height: 720 }, screen, null);
  expect(zoom).toBeGreaterThan(0.5);
  expect(page.x * zoom + x).toBeGreaterThanOrEqual(0);
  expect((page.x + page.width) * zoom + x).toBeLessThanOrEqual(760);
  expect((page.y + page.height) * zoom + y).toBeLessThanOrEqual(720);
});

test("where panes take the room, the page begins at the left and can be read", () => {
  const { x, zoom } = readableView(page, { width: 320, height: 720 }, screen, null);
  expect(zoom).toBeGreaterThanOrEqual(0.65);
  expect(page.x * zoom + x).toBeCloseTo(64);
});

test("where panes take the room, what is selected stands in the middle", () => {
  const chosen = { x: 500, y: 300, width: 160, height: 80 };
  const { x, y, zoom } = readableView(page, { width: 320, height: 720 }, screen, chosen);
  expect((chosen.x + 80) * zoom + x).toBeCloseTo(160);
  expect((chosen.y + 40) * zoom + y).toBeCloseTo(360);
});

test("of a page that no window could show readably the begin is shown", () => {
  const crowd = { x: 0, y: 0, width: 4000, height: 9000 };
  const { x, y, zoom } = readableView(crowd, { width: 900, height: 720 }, screen, null);
  expect({ x, zoom }).toEqual({ x: 64, zoom: 0.7 });
  expect(y).toBeCloseTo(28);
});

test("states are shown as a whole where no window is large enough, as long as they can be made out", () => {
  const many = { x: 0, y: 0, width: 1000, height: 2400 };
  const { zoom } = readableView(many, { width: 760, height: 720 }, screen, null, 0.25);
  expect(many.height * zoom).toBeLessThanOrEqual(720);
});
