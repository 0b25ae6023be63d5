import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { ObstacleSchema } from "../protocol.ts";
import { isMoving, placeAt } from "./moving.ts";

function obstacle(x: number, y: number, speed: number, ...route: [number, number][]) {
  return create(ObstacleSchema, { x, y, radius: 1, speed, route: route.map(([px, py]) => ({ x: px, y: py })) });
}

describe("an obstacle that moves", () => {
  it("goes there and back", () => {
    const one = obstacle(0, 0, 2, [10, 0], [10, 4]);
    expect(isMoving(one)).toBe(true);
    expect(placeAt(one, 0)).toEqual({ x: 0, y: 0 });
    expect(placeAt(one, 2.5)).toEqual({ x: 5, y: 0 });
    expect(placeAt(one, 6)).toEqual({ x: 10, y: 2 });
    expect(placeAt(one, 7)).toEqual({ x: 10, y: 4 });
    expect(placeAt(one, 10)).toEqual({ x: 8, y: 0 });
    expect(placeAt(one, 16.5)).toEqual({ x: 5, y: 0 });
  });

  it("goes round and round where its route ends where it begins", () => {
    const one = obstacle(0, 0, 1, [3, 0], [3, 4], [0, 0]);
    expect(placeAt(one, 9.5)).toEqual({ x: 1.5, y: 2 });
    expect(placeAt(one, 13)).toEqual({ x: 1, y: 0 });
  });

  it("passes over points that are given twice", () => {
    const one = obstacle(0, 0, 1, [0, 0], [2, 0], [2, 0], [4, 0]);
    expect(placeAt(one, 0)).toEqual({ x: 0, y: 0 });
    expect(placeAt(one, 3)).toEqual({ x: 3, y: 0 });
    expect(placeAt(one, 5)).toEqual({ x: 3, y: 0 });
  });

  it("stands without a route", () => {
    expect(isMoving(obstacle(1, 2, 0))).toBe(false);
    expect(placeAt(obstacle(1, 2, 0), 5)).toEqual({ x: 1, y: 2 });
  });
});
