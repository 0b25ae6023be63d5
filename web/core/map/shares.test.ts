import { expect, test } from "vitest";
import { middleOf } from "./shares.ts";

test("the middle of a way lies half of it along, on whichever leg that is", () => {
  expect(middleOf([0, 0, 10, 0])).toEqual({ x: 5, y: 0 });
  expect(middleOf([0, 0, 10, 0, 10, 30])).toEqual({ x: 10, y: 10 });
  expect(middleOf([0, 0, 30, 0, 30, 0, 30, 10])).toEqual({ x: 20, y: 0 });
});

test("a way that is one place has its middle there", () => {
  expect(middleOf([3, 4, 3, 4])).toEqual({ x: 3, y: 4 });
});
