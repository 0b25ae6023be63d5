import { create } from "@bufbuild/protobuf";
import { beforeEach, expect, test } from "vitest";
import type { Connection } from "../../core/connection.ts";
import type { Look } from "../../core/look_back.ts";
import { Model } from "../../core/model.ts";
import {
  Log_EntrySchema,
  Log_Kind,
  MomentSchema,
  type Order,
  ReplySchema,
  TimeLineSchema,
} from "../../core/protocol.ts";
import { actionsOf } from "../../ui/commands/declared.ts";
import { elsewhen } from "../session/elsewhen.ts";
import type { Session } from "../session/session.ts";
import { Ui } from "../session/ui.ts";
import { kTimeTable } from "./time_actions.ts";
import { type TimeTravel, travelOf } from "./time_travel.ts";

let session: Session;
let travel: TimeTravel;
let asked: Look[];
let answer: (error?: string) => Promise<void>;

beforeEach(() => {
  window.localStorage.clear();
  const model = new Model();
  const ui = new Ui(model, window.localStorage, { width: 1600, height: 1000 });
  asked = [];
  const answers: ((error: string) => void)[] = [];
  const ask = (order: Order) => {
    if (order.case === "lookBack") asked.push(order.value);
    return new Promise((resolve) => {
      answers.push((error) => resolve(create(ReplySchema, { ok: error === "", error })));
    });
  };
  session = { model, ui, connection: { ask } as unknown as Connection };
  travel = travelOf(session);
  answer = async (error = "") => {
    answers.shift()!(error);
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  model.set("timeLine", create(TimeLineSchema, { end: 100, lastCycle: 1000n, knownTo: 100 }));
});

const arrive = (time: number, more = {}) =>
  session.model.set("moment", create(MomentSchema, { time, cycle: BigInt(Math.round(time * 10)), ...more }));

const action = (id: string) => actionsOf(kTimeTable, session).find((one) => one.id === id)!;

test("what is wanted is shown until it is there, and then what is there", async () => {
  expect(travel.whereabouts()).toMatchObject({ isNow: true, time: 100 });
  travel.go(30);
  expect(travel.whereabouts()).toMatchObject({ isNow: false, isComing: true, time: 30 });
  expect(asked).toEqual([{ to: { case: "time", value: 30 }, speed: 0 }]);
  arrive(29.9);
  expect(travel.whereabouts().time).toBe(30); // not answered yet: it may be the moment before
  await answer();
  expect(travel.whereabouts()).toMatchObject({ isNow: false, isComing: false, time: 29.9, cycle: 299 });
});

test("a moment that comes after the answer is waited for", async () => {
  travel.go(30);
  await answer();
  expect(travel.whereabouts().time).toBe(30);
  arrive(30, { isComing: true });
  expect(travel.whereabouts().isComing).toBe(true);
  arrive(30);
  expect(travel.whereabouts()).toMatchObject({ isComing: false, time: 30 });
});

test("a moment that can't be shown is told, and one stays where one was", async () => {
  travel.go(30);
  await answer("this run can't be computed again");
  expect(session.ui.get("notice")?.text).toBe("This run can't be computed again.");
  expect(travel.whereabouts()).toMatchObject({ isNow: true, time: 100 });
});

test("goes from event to event, over those of kinds that are hidden, and behind the last one to now", () => {
  const kinds = [Log_Kind.STEP, Log_Kind.STATE, Log_Kind.STEP];
  const log = kinds.map((kind, i) => create(Log_EntrySchema, { number: BigInt(i + 1), time: 10 * (i + 1), kind }));
  session.model.set("log", log);
  travel.does.hide(new Set(["state"]));
  travel.does.event(-1);
  travel.does.event(-1);
  expect(travel.whereabouts().time).toBe(10);
  travel.does.event(1);
  expect(travel.whereabouts().time).toBe(30);
  travel.does.event(1);
  expect(travel.get("wanted")).toBeNull();
});

test("plays at the speed that was chosen, both ways, and another speed counts at once", async () => {
  arrive(30);
  travel.does.speed(5);
  travel.does.play(-1);
  expect(asked.at(-1)).toEqual({ to: { case: "here", value: true }, speed: -5 });
  await answer();
  arrive(30, { speed: -5 });
  await new Promise((resolve) => setTimeout(resolve, 40));
  travel.does.speed(10);
  await new Promise((resolve) => setTimeout(resolve, 40));
  expect(asked.at(-1)).toEqual({ to: { case: "here", value: true }, speed: -10 });
});

test("why one can't go is told: the server says why, or there is nothing in that direction", () => {
  expect(action("time-play").blocked).toBe("The run is shown as it goes on.");
  expect(action("time-back").blocked).toBeUndefined();
  expect(action("time-event-back").blocked).toBe("Nothing has happened.");
  session.model.set("timeLine", create(TimeLineSchema, { end: 100, whyNot: "its robots are elsewhere, in real time" }));
  for (const id of ["time-back", "time-find", "time-beginning"])
    expect(action(id).blocked, id).toBe("Its robots are elsewhere, in real time.");
  travel.go(30);
  expect(asked).toEqual([]);
});

test("in a recording nothing goes on: its end is no now, and playing there begins anew", async () => {
  session.model.set("timeLine", create(TimeLineSchema, { end: 100, recording: "demo_c" }));
  arrive(100);
  expect(elsewhen(session.model)).toBe("This is a recording: nothing goes on in it.");
  expect(action("time-now")).toMatchObject({
    label: "Look at the end of the recording",
    blocked: "This is the end of the recording.",
  });
  travel.does.play(1);
  expect(asked.at(-1)).toEqual({ to: { case: "time", value: 0 }, speed: 0 });
  await answer();
  arrive(0);
  await new Promise((resolve) => setTimeout(resolve, 40));
  expect(asked.at(-1)).toEqual({ to: { case: "here", value: true }, speed: 1 });
});

test("speed and hidden kinds stay over a reload", () => {
  travel.does.speed(50);
  travel.does.hide(new Set(["state", "message"]));
  const model = new Model();
  const again = travelOf({ ...session, model });
  expect(again.get("speed")).toBe(50);
  expect(again.get("hidden")).toEqual(new Set(["message", "state"]));
});
