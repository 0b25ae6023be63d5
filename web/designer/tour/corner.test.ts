import { expect, test } from "vitest";
import { bestCorner, isInside, overlap } from "./corner.ts";

const area = { x: 200, y: 50, width: 800, height: 700 };
const card = { width: 380, height: 140 };

test("the card stands where it lies on nothing, and stays there while that is so", () => {
  expect(bestCorner(area, card, [], "bottom-right")).toBe("bottom-right");
  const low = { x: 800, y: 650, width: 150, height: 60 };
  expect(bestCorner(area, card, [low], "bottom-right")).toBe("top-right");
  expect(bestCorner(area, card, [], "top-right")).toBe("top-right");
  const high = { x: 800, y: 80, width: 150, height: 60 };
  expect(bestCorner(area, card, [low, high], "bottom-right")).toBe("bottom-left");
});

test("where something is drawn in every corner it takes the one with the least", () => {
  const small = { x: 270, y: 70, width: 10, height: 10 };
  const others = [
    { x: 800, y: 650, width: 150, height: 60 },
    { x: 800, y: 80, width: 150, height: 60 },
    { x: 270, y: 650, width: 150, height: 60 },
  ];
  expect(bestCorner(area, card, [small, ...others], "bottom-right")).toBe("top-left");
});

test("boxes that only touch do not lie on each other", () => {
  const a = { x: 0, y: 0, width: 10, height: 10 };
  expect(overlap(a, { ...a, x: 10 })).toBe(0);
  expect(overlap(a, { ...a, x: 5, y: 5 })).toBe(25);
  expect(isInside({ ...a, width: 5 }, a)).toBe(true);
  expect(isInside({ ...a, x: 1 }, a)).toBe(false);
});
