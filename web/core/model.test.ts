import { create, type MessageInitShape } from "@bufbuild/protobuf";
import { expect, onTestFinished, test, vi } from "vitest";
import { kLogLength, Model } from "./model.ts";
import { FailsafeStandings_State, Status_Mode, ToBrowserSchema } from "./protocol.ts";
import { kRecordBytes, writeRecord } from "./robots.ts";
import { selectItem, selectRobots } from "./selection.ts";

function say(model: Model, body: NonNullable<MessageInitShape<typeof ToBrowserSchema>["body"]>): void {
  model.accept(create(ToBrowserSchema, { body }));
}

function record(id: number, x: number): Uint8Array {
  const bytes = new Uint8Array(kRecordBytes);
  writeRecord(new DataView(bytes.buffer), 0, { id, x, y: 0, heading: 0, flags: 1 });
  return bytes;
}

test("who shows a part hears of that part and of no other", () => {
  const model = new Model();
  const status = vi.fn();
  const plan = vi.fn();
  const end = model.subscribe("status", status);
  model.subscribe("plan", plan);
  say(model, { case: "status", value: { time: 3 } });
  end();
  say(model, { case: "status", value: { time: 4 } });
  expect(status).toHaveBeenCalledTimes(1);
  expect(plan).not.toHaveBeenCalled();
  expect(model.get("status")?.time).toBe(4);
});

test("log entries are added once, and the oldest go", () => {
  const model = new Model();
  const entries = (from: number, count: number) =>
    Array.from({ length: count }, (_, i) => ({ number: BigInt(from + i), text: `${from + i}` }));
  say(model, { case: "log", value: { entries: entries(1, 3), isWhole: true } });
  say(model, { case: "log", value: { entries: entries(3, 2) } });
  expect(model.get("log").map(({ text }) => text)).toEqual(["1", "2", "3", "4"]);
  say(model, { case: "log", value: { entries: entries(5, kLogLength) } });
  expect(model.get("log")).toHaveLength(kLogLength);
  expect(model.get("log")[0]?.text).toBe("5");
});

test("frames move robots without a part being told, and time is told now and then", () => {
  const model = new Model();
  const frames = vi.fn();
  const time = vi.fn();
  model.onFrame(frames);
  model.subscribe("time", time);
  for (let i = 1; i <= 20; ++i) {
    say(model, { case: "frame", value: { number: BigInt(i), time: i / 10, robots: record(4, i) } });
  }
  expect(frames).toHaveBeenCalledTimes(20);
  expect(time.mock.calls.length).toBeLessThan(4);
  expect(model.placeOf(4)?.x).toBe(20);
});

test("a restart, when time goes back, forgets the trails", () => {
  const model = new Model();
  say(model, { case: "frame", value: { number: 1n, time: 50, robots: record(4, 1) } });
  say(model, { case: "frame", value: { number: 2n, time: 0.1, robots: record(4, 9) } });
  expect(model.trails.get(4)?.count).toBe(1);
});

test("another session forgets the log, the questions and what was selected", () => {
  const model = new Model();
  say(model, { case: "welcome", value: { client: 1, session: "a" } });
  say(model, { case: "log", value: { entries: [{ number: 1n }], isWhole: true } });
  model.select(selectRobots([1]));
  say(model, { case: "welcome", value: { client: 1, session: "b" } });
  expect(model.get("log")).toEqual([]);
  expect(model.get("selection").robots).toEqual([]);
});

test("what is selected stays only as long as it is there", () => {
  const model = new Model();
  say(model, { case: "roster", value: { robots: [{ id: 1 }, { id: 2 }] } });
  model.select(selectRobots([1, 2]));
  say(model, { case: "roster", value: { robots: [{ id: 2 }] } });
  expect(model.get("selection").robots).toEqual([2]);
  say(model, { case: "scene", value: { measures: [{ name: "A" }, { name: "B" }] } });
  model.select(selectItem({ kind: "measure", index: 1 }));
  say(model, { case: "scene", value: { measures: [{ name: "A" }] } });
  expect(model.get("selection").items).toEqual([]);
});

test("a unit's robots are those of the units in it too", () => {
  const model = new Model();
  say(model, {
    case: "roster",
    value: {
      robots: [{ id: 1 }, { id: 2 }, { id: 3 }],
      units: [
        { name: "all", members: [3], parent: -1 },
        { name: "left", members: [1], parent: 0 },
        { name: "right", members: [2], parent: 0 },
      ],
    },
  });
  expect(model.get("roster").robotsOf("ALL")).toEqual([3, 1, 2]);
  expect(model.get("roster").robotsOf("left")).toEqual([1]);
  expect(model.get("roster").robotsOf("nobody")).toEqual([]);
});

test("what the mission sets about the map is applied when it changes, and not against the person's later choice", () => {
  const model = new Model();
  say(model, { case: "status", value: { options: ["USE-MILITARY-STYLE"] } });
  expect(model.get("map").military).toBe(true);
  model.updateMap({ military: false });
  say(model, { case: "status", value: { options: ["USE-MILITARY-STYLE"] } });
  expect(model.get("map").military).toBe(false);
});

test("the operator is who the clients say", () => {
  const model = new Model();
  expect(model.isOperator()).toBe(false);
  say(model, { case: "welcome", value: { client: 7 } });
  say(model, { case: "clients", value: { operator: 7 } });
  expect(model.isOperator()).toBe(true);
});

test("who has not been started has the place where START will put it, until it is on the map", () => {
  const model = new Model();
  const starts = vi.fn();
  model.subscribe("starts", starts);
  say(model, { case: "starts", value: { robots: record(4, 20) } });
  expect(model.placeOf(4)?.x).toBe(20);
  expect(starts).toHaveBeenCalledTimes(1);
  say(model, { case: "starts", value: {} });
  say(model, { case: "frame", value: { number: 1n, time: 0.1, robots: record(4, 21) } });
  expect(model.placeOf(4)?.x).toBe(21);
  expect(model.get("starts").count).toBe(0);
});

test("robots of a paused or stepped run are where the frame says", () => {
  const model = new Model();
  model.glide.isWanted = true;
  say(model, { case: "status", value: { mode: Status_Mode.PAUSED } });
  for (let i = 1; i <= 3; ++i) say(model, { case: "frame", value: { number: 1n, time: i / 10, robots: record(4, i) } });
  model.robots.share = 0;
  expect(model.placeOf(4)?.x).toBe(3);
});

test("where a run has paused is known until it goes on", () => {
  const model = new Model();
  say(model, { case: "breakpoints", value: { breakpoints: [{ id: 3 }] } });
  say(model, { case: "halted", value: { hits: [{ breakpoint: 3, robot: 1, text: "it is near" }], time: 2 } });
  expect(model.get("breakpoints")[0]?.id).toBe(3);
  expect(model.get("halted")?.hits[0]?.text).toBe("it is near");
  say(model, { case: "halted", value: {} });
  expect(model.get("halted")).toBeNull();
});

test("knows which values are held", () => {
  const model = new Model();
  expect(model.get("held")).toEqual([]);
  say(model, { case: "heldValues", value: { values: [{ robot: 2, port: "movement.near", value: "true" }] } });
  expect(model.get("held").map(({ robot, port, value }) => [robot, port, value])).toEqual([
    [2, "movement.near", "true"],
  ]);
  say(model, { case: "heldValues", value: {} });
  expect(model.get("held")).toEqual([]);
});

test("how failsafes stand is kept until it changes, and forgotten with the run", () => {
  vi.useFakeTimers();
  onTestFinished(() => {
    vi.useRealTimers();
  });
  const model = new Model();
  const stand = (robot: number, used: number) => ({ robot, rows: [{ state: FailsafeStandings_State.NEAR, used }] });
  const frame = (number: bigint, time: number, failsafes: ReturnType<typeof stand>[]) => {
    say(model, { case: "frame", value: { number, time, failsafes } });
    vi.advanceTimersByTime(200);
  };
  frame(1n, 5, [stand(1, 50), stand(2, 60)]);
  frame(2n, 5.1, [stand(1, 70)]);
  const known = model.get("standings");
  expect([known.get(1)?.rows[0]?.used, known.get(2)?.rows[0]?.used]).toEqual([70, 60]);
  frame(3n, 5.2, []);
  expect(model.get("standings")).toBe(known);
  frame(4n, 0.1, [stand(2, 55)]);
  expect([...model.get("standings").keys()]).toEqual([2]);
});

test("who looks back may order nothing until it is told of now again", () => {
  const model = new Model();
  say(model, { case: "welcome", value: { client: 7 } });
  say(model, { case: "clients", value: { operator: 7 } });
  expect(model.mayOrder()).toBe(true);
  say(model, { case: "moment", value: { isNow: false, time: 3 } });
  expect([model.isElsewhen(), model.mayOrder(), model.isOperator()]).toEqual([true, false, true]);
  say(model, { case: "moment", value: { isNow: true } });
  expect(model.mayOrder()).toBe(true);
  say(model, { case: "moment", value: { isNow: false, time: 3 } });
  say(model, { case: "welcome", value: { client: 7 } }); // the connection was lost, and is another one
  expect(model.mayOrder()).toBe(true);
  say(model, { case: "timeLine", value: { recording: "demo_c", end: 300 } });
  expect([model.isRecording(), model.mayOrder()]).toEqual([true, false]);
});

test("an earlier moment keeps the trails that came for it, and what goes on is not taken from there", () => {
  const model = new Model();
  const series = vi.fn();
  model.onSeries(series);
  say(model, { case: "frame", value: { number: 1n, time: 50, robots: record(4, 90) } });
  say(model, { case: "moment", value: { isNow: false, time: 20 } });
  const points = new Uint8Array(Float32Array.of(1, 0, 10, 2, 0, 20).buffer);
  say(model, { case: "trails", value: { trails: [{ robot: 4, points }] } });
  say(model, { case: "frame", value: { number: 2n, time: 20, robots: record(4, 2), series: {} } });
  expect(model.trails.get(4)?.count).toBe(2);
  expect(series).not.toHaveBeenCalled();
  // Further back without trails of its own: what is known of later goes.
  say(model, { case: "frame", value: { number: 3n, time: 12, robots: record(4, 1) } });
  expect(model.trails.get(4)?.count).toBe(1);
});

test("robots don't glide from one moment to another one, but do while time passes there", () => {
  const model = new Model();
  const take = vi.spyOn(model.glide, "take");
  say(model, { case: "status", value: { mode: Status_Mode.RUNNING } });
  say(model, { case: "moment", value: { isNow: false, time: 20 } });
  say(model, { case: "frame", value: { number: 1n, time: 20, robots: record(4, 2) } });
  say(model, { case: "frame", value: { number: 2n, time: 30, robots: record(4, 3) } });
  expect(take.mock.lastCall?.[1]).toBe(0);
  say(model, { case: "moment", value: { isNow: false, time: 30, speed: 2 } });
  say(model, { case: "frame", value: { number: 3n, time: 30.1, robots: record(4, 4) } });
  expect(take.mock.lastCall?.[1]).toBeCloseTo(0.1);
});
