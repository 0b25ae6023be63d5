import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { byDistance, ghostAt, isShown, sampleBefore } from "./other_future.ts";
import { OtherFutureSchema } from "./protocol.ts";

const future = create(OtherFutureSchema, {
  name: "What if",
  times: [10, 11, 12],
  robots: [
    { robot: 1, x: [0, 2, 4], y: [0, 0, 0], heading: [3, -3, -3], apart: [0, 1, 2], mostApart: 2 },
    { robot: 2, x: [Number.NaN, 5, 6], y: [Number.NaN, 5, 6], heading: [0, 0, 0], apart: [], mostApart: 7 },
  ],
});

test("the last sample before a moment is found", () => {
  expect([9, 10, 11.5, 40].map((time) => sampleBefore(future.times, time))).toEqual([-1, 0, 1, 2]);
});

test("ghosts go straight from sample to sample, turn the shorter way, and stand at the end", () => {
  const at = (time: number) => ghostAt(future, future.robots[0]!, time);
  expect(at(9)).toBeUndefined();
  expect(at(10.5)).toMatchObject({ id: 1, x: 1, y: 0 });
  expect(Math.abs(at(10.5)!.heading)).toBeCloseTo(Math.PI, 1);
  expect(at(99)).toMatchObject({ x: 4, heading: -3 });
});

test("who is not in the world has no ghost", () => {
  expect(ghostAt(future, future.robots[1]!, 10)).toBeUndefined();
  expect(ghostAt(future, future.robots[1]!, 11)).toMatchObject({ x: 5 });
});

test("who parts most comes first, and what is under way is not shown", () => {
  expect(byDistance(future).map(({ robot }) => robot)).toEqual([2, 1]);
  expect(isShown(future)).toBe(true);
  expect(isShown(create(OtherFutureSchema, { name: "What if", times: [1], isUnderWay: true }))).toBe(false);
});
