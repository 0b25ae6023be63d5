import { expect, test } from "vitest";
import { Traces, tracePath, traceRange } from "./traces.ts";

test("a moment gives one sample, and going back begins anew", () => {
  const traces = new Traces();
  traces.at(1);
  const first = traces.add("a", 5);
  expect(first).toEqual([5]);
  traces.at(1);
  expect(traces.add("a", 6)).toBe(first);
  traces.at(2);
  expect(traces.add("a", 7)).toEqual([5, 7]);
  traces.at(0);
  expect(traces.add("a", 8)).toEqual([8]);
});

test("no more than the last moments are kept", () => {
  const traces = new Traces();
  let samples: readonly number[] = [];
  for (let time = 0; time < 200; ++time) {
    traces.at(time);
    samples = traces.add("a", time);
  }
  expect(samples).toHaveLength(80);
  expect(samples.at(-1)).toBe(199);
  traces.keep(new Set());
  traces.at(300);
  expect(traces.add("a", 1)).toEqual([1]);
});

test("a plot fills its box, and a value that stays is a line in the middle", () => {
  expect(tracePath([0, 1], 79, 12)).toBe("M78.0 11.0L79.0 1.0");
  expect(tracePath([3, 3], 79, 12)).toBe("M78.0 6.0L79.0 6.0");
  expect(tracePath([1], 79, 12)).toBe("");
  expect(tracePath([Number.NaN, Number.POSITIVE_INFINITY], 79, 12)).toBe("");
});

test("a plot knows between which values it goes, and over how long", () => {
  expect(traceRange([2, Number.NaN, -1, 1])).toEqual({ low: -1, high: 2 });
  expect(traceRange([3, 3])).toBeUndefined();
  expect(traceRange([3])).toBeUndefined();
  const traces = new Traces();
  expect(traces.span).toBe(0);
  for (let time = 0; time < 200; ++time) traces.at(time);
  expect(traces.span).toBe(79);
  traces.at(5);
  expect(traces.span).toBe(0);
});
