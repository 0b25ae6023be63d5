import { expect, test, vi } from "vitest";
import { Pace } from "./pace.ts";

function setUp() {
  const pictures: (() => void)[] = [];
  const pace = new Pace((done) => pictures.push(done));
  return { pace, pictures };
}

test("who listens is told once for all changes before a picture, in the order in which they were heard of", () => {
  const { pace, pictures } = setUp();
  const told: string[] = [];
  const [a, b] = [() => void told.push("a"), () => void told.push("b")];
  for (const listener of [a, b, a, b, a]) pace.soon(listener);
  expect(told).toEqual([]);
  expect(pictures).toHaveLength(1);
  pictures[0]!();
  expect(told).toEqual(["a", "b"]);
  pictures[0]!();
  expect(told).toEqual(["a", "b"]);
});

test("what changes while people are told is told with the next picture", () => {
  const { pace, pictures } = setUp();
  const second = vi.fn();
  pace.soon(() => pace.soon(second));
  pictures[0]!();
  expect(second).not.toHaveBeenCalled();
  expect(pictures).toHaveLength(2);
  pictures[1]!();
  expect(second).toHaveBeenCalledTimes(1);
});

test("who has gone is not told", () => {
  const { pace, pictures } = setUp();
  const listener = vi.fn();
  pace.soon(listener);
  pace.forget(listener);
  pictures[0]!();
  expect(listener).not.toHaveBeenCalled();
});

test("what can wait is told with what comes next, or after a moment", () => {
  vi.useFakeTimers();
  const { pace, pictures } = setUp();
  const [patient, other] = [vi.fn(), vi.fn()];
  pace.withNext(patient);
  expect(pictures).toHaveLength(0);
  pace.soon(other);
  pictures[0]!();
  expect(patient).toHaveBeenCalledTimes(1);
  vi.advanceTimersByTime(1000);
  expect(pictures).toHaveLength(1);
  pace.withNext(patient);
  vi.advanceTimersByTime(1000);
  expect(pictures).toHaveLength(2);
  pictures[1]!();
  expect(patient).toHaveBeenCalledTimes(2);
  pace.withNext(patient);
  pace.forget(patient);
  vi.advanceTimersByTime(1000);
  expect(patient).toHaveBeenCalledTimes(2);
  vi.useRealTimers();
});
