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

test("how failsafes stand is asked for while somebody looks at it", () => {
  const watching = new Watching(() => undefined);
  watching.wish("selection", { details: [1] });
  expect(watching.sum()).toMatchObject({ withFailsafes: false });
  watching.wish("failsafes", { failsafes: true });
  expect(watching.sum()).toMatchObject({ details: [1], withFailsafes: true });
  watching.wish("failsafes", null);
  expect(watching.sum()).toMatchObject({ withFailsafes: false });
});

test("some ports are asked for by their paths, unless somebody wishes all", () => {
  const watching = new Watching(() => undefined);
  watching.wish("drawing", { details: [1], ports: ["movement", "movement.Noise"] });
  watching.wish("details", { ports: ["movement.Noise", "movement.Noise.persistence"] });
  expect(watching.sum()).toMatchObject({
    withPorts: true,
    ports: ["movement", "movement.Noise", "movement.Noise.persistence"],
  });
  watching.wish("ports", { ports: true });
  expect(watching.sum()).toMatchObject({ withPorts: true, ports: [] });
  watching.wish("ports", null);
  watching.wish("details", null);
  watching.wish("drawing", { details: [1], ports: [] });
  expect(watching.sum()).toMatchObject({ withPorts: false, ports: [] });
});

test("the same is not told twice, but after a new connection", () => {
  const send = vi.fn();
  const watching = new Watching(send);
  watching.wish("drawing", { details: [1], ports: ["movement"] });
  vi.runAllTimers();
  watching.wish("drawing", { details: [1], ports: ["movement"] });
  vi.runAllTimers();
  expect(send).toHaveBeenCalledTimes(1);
  watching.flush();
  expect(send).toHaveBeenCalledTimes(2);
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
