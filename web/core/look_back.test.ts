import { create } from "@bufbuild/protobuf";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { type Look, Looker, withLook } from "./look_back.ts";
import { type Order, type Reply, ReplySchema } from "./protocol.ts";

const at = (time: number): Look => ({ to: { case: "time", value: time } });
const step = (cycles: number): Look => ({ to: { case: "cycles", value: BigInt(cycles) } });

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function setUp() {
  const asked: Look[] = [];
  const answers: ((reply: Reply) => void)[] = [];
  const refused = vi.fn();
  const ask = (order: Order) => {
    if (order.case === "lookBack") asked.push(order.value);
    return new Promise<Reply>((resolve) => answers.push(resolve));
  };
  const looker = new Looker({ ask, refused, now: () => Date.now() });
  const answer = async (error = "") => {
    answers.shift()!(create(ReplySchema, { ok: error === "", error }));
    await vi.advanceTimersByTimeAsync(0);
  };
  return { looker, asked, answer, refused };
}

test("one moment is asked for at a time, and of those that wait the newest wins", async () => {
  const { looker, asked, answer } = setUp();
  for (let i = 1; i <= 50; ++i) looker.look(at(i));
  expect(asked).toEqual([at(1)]);
  await vi.advanceTimersByTimeAsync(500);
  expect(asked).toHaveLength(1);
  await answer();
  expect(asked).toEqual([at(1), at(50)]);
  await answer();
  expect(asked).toHaveLength(2);
});

test("a server that answers at once is asked no more than forty times a second", async () => {
  const { looker, asked, answer } = setUp();
  for (let ms = 0; ms < 1000; ms += 5) {
    looker.look(at(ms));
    if (asked.length > 0) await answer().catch(() => {});
    await vi.advanceTimersByTimeAsync(5);
  }
  expect(asked.length).toBeGreaterThan(30);
  expect(asked.length).toBeLessThanOrEqual(41);
});

test("steps that wait add up, and stand behind a moment that waits", () => {
  expect(withLook([step(1)], step(1))).toEqual([{ ...step(2), speed: 0 }]);
  expect(withLook([step(3)], step(-1))).toEqual([{ ...step(2), speed: 0 }]);
  expect(withLook([at(7)], step(-1))).toEqual([at(7), step(-1)]);
  expect(withLook([at(7), step(-1)], step(-1))).toEqual([at(7), { ...step(-2), speed: 0 }]);
  expect(withLook([at(7), step(-1)], at(9))).toEqual([at(9)]);
  expect(withLook([], step(1))).toEqual([step(1)]);
});

test("another speed is that of what waits", () => {
  const here: Look = { to: { case: "here", value: true }, speed: 5 };
  expect(withLook([], here)).toEqual([here]);
  expect(withLook([at(7)], here)).toEqual([{ ...at(7), speed: 5 }]);
  expect(withLook([here], step(1))).toEqual([step(1)]);
});

test("why a moment can't be shown is told, unless another one is asked for meanwhile", async () => {
  const { looker, asked, answer, refused } = setUp();
  looker.look(at(1));
  looker.look(at(2));
  looker.look(step(1));
  await vi.advanceTimersByTimeAsync(100);
  await answer("there is no such moment");
  expect(refused).not.toHaveBeenCalled();
  expect(asked).toEqual([at(1), at(2)]);
  await vi.advanceTimersByTimeAsync(100);
  await answer("there is none there either");
  expect(refused).toHaveBeenCalledWith("there is none there either");
});
