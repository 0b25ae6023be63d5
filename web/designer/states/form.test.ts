import { expect, test } from "vitest";
import { widthOf } from "../drawing/text_width.ts";
import { farNameSize, nameParts } from "./form.ts";

test("a name is broken between its words", () => {
  expect(nameParts("FindTheDoor2")).toEqual(["Find", "The", "Door2"]);
  expect(nameParts("find_the__door")).toEqual(["find_", "the__", "door"]);
  expect(nameParts("GPSLost")).toEqual(["GPSLost"]);
  expect(nameParts("Searching")).toEqual(["Searching"]);
});

test("from far away letters are as large as the longest word allows", () => {
  expect(farNameSize({ name: "Go", width: 128 })).toBe(24);
  const size = farNameSize({ name: "SearchingEverywhere", width: 128 });
  expect(size).toBeGreaterThan(14);
  expect(size).toBeLessThan(24);
  expect(widthOf("Everywhere", size, true)).toBeLessThanOrEqual(104);
  expect(farNameSize({ name: "X".repeat(80), width: 128 })).toBe(14);
});
