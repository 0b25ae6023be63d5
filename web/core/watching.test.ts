import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Series_Quantity } from "./protocol.ts";
import { kMostWatched, Watching } from "./watching.ts";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("the server is told the sum of what panels wish, once for many changes", () => {
  const send = vi.fn();
  const watching = new Watching(send);
  watching.wish("map", { rate: 30, stations: true, details: [1, 2] });
  watching.wish("state", { details: [2, 3], ports: true, rate: 10 });
  vi.runAllTimers();
  expect(send).toHaveBeenCalledTimes(1);
  expect(send.mock.calls[0]![0]).toMatchObject({
    rate: 30,
    details: [1, 2, 3],
    withPorts: true,
    withReadings: false,
    withStations: true,
  });
});

test("what a panel no longer wishes is no longer watched", () => {
  const send = vi.fn();
  const watching = new Watching(send);
  const series = { id: watching.seriesId(), quantity: Series_Quantity.SPEED, robot: 1 };
  watching.wish("plots", { series: [series] });
  watching.wish("plots", null);
  vi.runAllTimers();
  expect(watching.sum().series).toEqual([]);
});

test("no more is asked for than the server gives", () => {
  const watching = new Watching(() => undefined);
  watching.wish("map", { details: Array.from({ length: 500 }, (_, i) => i + 1) });
  expect(watching.sum().details).toHaveLength(kMostWatched);
});
