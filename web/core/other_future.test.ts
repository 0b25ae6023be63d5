import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { aloneIn, byDistance, ghostAt, isAlone, isShown, sampleBefore, toldApart } from "./other_future.ts";
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

test("who is in one of both alone is named, and what was told in one alone is by time", () => {
  const apart = create(OtherFutureSchema, {
    robots: [
      { robot: 7, own: { isThere: true }, other: { isThere: false } },
      { robot: 3, own: { isThere: true } },
      { robot: 1, own: { isThere: true }, other: { isThere: true } },
      { robot: 9, own: {}, other: { isThere: true } },
      { robot: 4 },
    ],
    toldOwn: [{ time: 3, text: "b" }],
    toldOther: [
      { time: 1, text: "a" },
      { time: 4, text: "c" },
    ],
  });
  expect(aloneIn(apart, "own")).toEqual([3, 7]);
  expect(aloneIn(apart, "other")).toEqual([9]);
  expect(isAlone(apart.robots[2]!)).toBeUndefined();
  expect(isAlone(apart.robots[4]!)).toBeUndefined();
  expect(toldApart(apart).map(({ side, entry }) => `${side} ${entry.text}`)).toEqual(["other a", "own b", "other c"]);
});

test("who parts most comes first, and what is under way is not shown", () => {
  expect(byDistance(future).map(({ robot }) => robot)).toEqual([2, 1]);
  expect(isShown(future)).toBe(true);
  expect(isShown(create(OtherFutureSchema, { name: "What if", times: [1], isUnderWay: true }))).toBe(false);
});
