import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Pulse } from "./pulse.ts";

beforeEach(() => void vi.useFakeTimers({ now: 1_000_000 }));
afterEach(() => void vi.useRealTimers());

/** `answers`: whether the other side answers our beats; `speaks`: whether it sends its own. */
function begin(other: { answers: boolean; speaks: boolean }) {
  const states: number[] = [];
  const sent: bigint[] = [];
  const pulse = new Pulse({
    send: (number) => {
      sent.push(number);
      if (other.answers) queueMicrotask(() => pulse.heard(number));
      else if (other.speaks) queueMicrotask(() => pulse.heard());
    },
    changed: (since) => states.push(since),
  });
  pulse.start();
  return { pulse, states, sent, other };
}

test("who answers is never silent, and each beat has a number of its own", async () => {
  const { states, sent } = begin({ answers: true, speaks: true });
  await vi.advanceTimersByTimeAsync(10_000);
  expect(states).toEqual([]);
  expect(new Set(sent).size).toBe(sent.length);
  expect(sent.length).toBeGreaterThan(30);
});

test("a second without a sign is silence, since the last one, until the next", async () => {
  const { states, other } = begin({ answers: true, speaks: true });
  await vi.advanceTimersByTimeAsync(2_000);
  const last = Date.now();
  other.answers = other.speaks = false;
  await vi.advanceTimersByTimeAsync(900);
  expect(states).toEqual([]);
  await vi.advanceTimersByTimeAsync(600);
  expect(states).toEqual([last]);
  other.answers = true;
  await vi.advanceTimersByTimeAsync(300);
  expect(states).toEqual([last, 0]);
});

test("signs that answer nothing we say are silence too: what we order arrives nowhere", async () => {
  const { states, other, sent } = begin({ answers: true, speaks: true });
  await vi.advanceTimersByTimeAsync(1_000);
  other.answers = false;
  await vi.advanceTimersByTimeAsync(2_000);
  expect(states.length).toBe(1);
  expect(states[0]).toBeGreaterThan(0);
  expect(sent.at(-1)).toBe(sent.at(-2));
});

test("a page that slept does not take its own sleep for the silence of the other side", async () => {
  const { states, pulse } = begin({ answers: true, speaks: true });
  await vi.advanceTimersByTimeAsync(1_000);
  // As while its computer sleeps: no timer runs, and then the clock has gone on by an hour.
  vi.setSystemTime(Date.now() + 3_600_000);
  await vi.advanceTimersByTimeAsync(500);
  expect(states).toEqual([]);
  pulse.stop();
});
