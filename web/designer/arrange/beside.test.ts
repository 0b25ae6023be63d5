import { expect, test } from "vitest";
import { placeAtSide, sideOf } from "./beside.ts";

const noise = { type: "Vector", inputs: [{ type: "duration" }] };
const avoid = { type: "Vector", inputs: [{ type: "Obstacles" }, { type: "length" }] };
const sensor = { type: "Obstacles", inputs: [{ type: "length" }] };
const sum = { type: "Vector", inputs: [{ type: "Vector" }] };

test("what takes the value of the selected node comes right of it, what it takes left, anything else below", () => {
  expect(sideOf(noise, sum)).toBe("right");
  expect(sideOf(sum, noise)).toBe("left");
  expect(sideOf(avoid, sensor)).toBe("left");
  expect(sideOf(sensor, avoid)).toBe("right");
  expect(sideOf(noise, avoid)).toBe("below");
});

test("of two sums the new one is further on, and what has no value is below", () => {
  expect(sideOf(sum, sum)).toBe("right");
  expect(sideOf({ type: "", inputs: [] }, noise)).toBe("below");
});

test("there is room between the two, on every side", () => {
  const box = { x: 100, y: 100, width: 200, height: 60 };
  const size = { width: 180, height: 80 };
  expect(placeAtSide("right", box, size)).toEqual({ x: 364, y: 100 });
  expect(placeAtSide("left", box, size)).toEqual({ x: -144, y: 100 });
  expect(placeAtSide("below", box, size)).toEqual({ x: 100, y: 192 });
});
