import { create } from "@bufbuild/protobuf";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Model } from "./model.ts";
import { readPast } from "./past_reader.ts";
import { type Order, PastSchema, type Reply, ReplySchema, TimeLineSchema } from "./protocol.ts";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

/** A run that is 100 s long; each time it is asked, 30 s more of it are known. */
function setUp() {
  const model = new Model();
  model.set("timeLine", create(TimeLineSchema, { end: 100 }));
  const server = { knownTo: 0, asked: 0, error: "" };
  const ask = async (order: Order): Promise<Reply> => {
    expect(order.case).toBe("readPast");
    ++server.asked;
    if (server.error !== "") return create(ReplySchema, { ok: false, error: server.error });
    server.knownTo = Math.min(model.get("timeLine")?.end ?? 0, server.knownTo + 30);
    return create(ReplySchema, {
      ok: true,
      result: { case: "past", value: create(PastSchema, { knownTo: server.knownTo }) },
    });
  };
  return { model, connection: { ask }, server };
}

test("asks until the whole run is there, and then no more", async () => {
  const { model, connection, server } = setUp();
  const known: number[] = [];
  readPast({ model, connection }, { wish: { statesOf: [1] }, take: (past) => known.push(past.knownTo), goesOn: false });
  await vi.advanceTimersByTimeAsync(60_000);
  expect(known).toEqual([30, 60, 90, 100]);
  expect(server.asked).toBe(4);
});

test("of a run that goes on, what has come since is read now and then, until nobody wants it", async () => {
  const { model, connection, server } = setUp();
  const take = vi.fn();
  const stop = readPast({ model, connection }, { wish: {}, take, goesOn: true });
  await vi.advanceTimersByTimeAsync(1000);
  expect(server.asked).toBe(4);
  model.set("timeLine", create(TimeLineSchema, { end: 110 }));
  await vi.advanceTimersByTimeAsync(1500);
  expect(take.mock.lastCall?.[0].knownTo).toBe(110);
  stop();
  const asked = server.asked;
  await vi.advanceTimersByTimeAsync(60_000);
  expect(server.asked).toBe(asked);
});

test("why there is nothing is told, and taken back when there is", async () => {
  const { model, connection, server } = setUp();
  server.error = "the run of these robots is elsewhere";
  const failed = vi.fn();
  const stop = readPast({ model, connection }, { wish: {}, take: () => {}, failed, goesOn: true });
  await vi.advanceTimersByTimeAsync(100);
  expect(failed).toHaveBeenLastCalledWith("the run of these robots is elsewhere");
  server.error = "";
  await vi.advanceTimersByTimeAsync(6000);
  expect(failed).toHaveBeenLastCalledWith("");
  stop();
});
