import { create } from "@bufbuild/protobuf";
import { beforeEach, expect, test } from "vitest";
import type { Connection } from "../../core/connection.ts";
import { Model } from "../../core/model.ts";
import {
  BookmarksSchema,
  ClientsSchema,
  MomentSchema,
  type Order,
  ReplySchema,
  TimeLineSchema,
  WelcomeSchema,
} from "../../core/protocol.ts";
import type { Session } from "../session/session.ts";
import { Ui } from "../session/ui.ts";
import { type BookmarkList, bookmarksOf } from "./bookmarks.ts";
import { travelOf } from "./time_travel.ts";

let session: Session;
let list: BookmarkList;
let asked: Order[];

beforeEach(() => {
  window.localStorage.clear();
  const model = new Model();
  const ui = new Ui(model, window.localStorage, { width: 1600, height: 1000 });
  asked = [];
  const ask = (order: Order) => {
    asked.push(order);
    return Promise.resolve(create(ReplySchema, { ok: true, result: { case: "bookmark", value: 7n } }));
  };
  session = { model, ui, connection: { ask } as unknown as Connection };
  list = bookmarksOf(session);
  model.set("link", { ...model.get("link"), state: "open" });
  model.set("welcome", create(WelcomeSchema, { client: 3 }));
  model.set("clients", create(ClientsSchema, { operator: 3 }));
  model.set("timeLine", create(TimeLineSchema, { end: 100, lastCycle: 1000n, knownTo: 100 }));
  tell([]);
});

const tell = (bookmarks: { id: bigint; time: number; note?: string }[]) =>
  session.model.set("bookmarks", create(BookmarksSchema, { bookmarks }));

test("the moment that is shown is marked: now as now, another one by its cycle, and a note is asked for", async () => {
  const marking = list.mark();
  expect(list.get("editing")).toBe(0n);
  expect(list.shown()).toEqual([{ id: 0n, time: 100, note: "", by: "" }]);
  await marking;
  expect(asked.at(-1)).toEqual({ case: "setBookmark", value: { now: true } });
  expect(list.shown().map(({ id }) => id)).toEqual([7n]);
  expect(list.get("editing")).toBe(7n);
  expect(list.get("isOpen")).toBe(true);
  session.model.set("moment", create(MomentSchema, { time: 29.9, cycle: 299n }));
  await list.mark();
  expect(asked.at(-1)).toEqual({ case: "setBookmark", value: { time: 29.9, cycle: 299n } });
});

test("a note that was not changed is not ordered", async () => {
  tell([{ id: 7n, time: 10, note: "as it was" }]);
  list.set("editing", 7n);
  await list.note(7n, "as it was");
  expect(asked).toEqual([]);
  expect(list.get("editing")).toBeNull();
  await list.note(7n, "mended");
  expect(asked.at(-1)).toEqual({ case: "setBookmark", value: { id: 7n, note: "mended" } });
});

test("a note that is kept before the server has answered is of the new one", async () => {
  const marking = list.mark();
  await list.note(0n, "quick");
  await marking;
  expect(asked.at(-1)).toEqual({ case: "setBookmark", value: { id: 7n, note: "quick" } });
  expect(list.get("editing")).toBeNull();
});

test("what was removed may come back", async () => {
  tell([{ id: 7n, time: 10, note: "odd" }]);
  await list.remove(7n);
  expect(list.get("removed")).toEqual({ id: 7n, name: "0:10.0 “odd”" });
  await list.takeBack();
  expect(asked.at(-1)).toEqual({ case: "removeBookmark", value: { id: 7n, takeBack: true } });
  expect(list.get("removed")).toBeNull();
});

test("only the operator makes them, also in a recording, where nothing else is ordered", () => {
  expect(list.whyNot).toBeUndefined();
  session.model.set("timeLine", create(TimeLineSchema, { end: 100, recording: "demo_c" }));
  expect(list.whyNot).toBeUndefined();
  session.model.set("clients", create(ClientsSchema, { operator: 4 }));
  expect(list.whyNot).toBe("Only the operator can do this: take control first.");
  session.model.set("bookmarks", null);
  expect(list.whyNot).toBe("The server knows of no bookmarks.");
});

test("they are gone to as events are, and hidden as these", () => {
  tell([
    { id: 1n, time: 20, note: "early" },
    { id: 2n, time: 60 },
  ]);
  const travel = travelOf(session);
  expect(travel.events().map(({ time, kind, text }) => [time, kind, text])).toEqual([
    [20, "bookmark", "early"],
    [60, "bookmark", ""],
  ]);
  travel.does.event(-1);
  expect(travel.whereabouts().time).toBe(60);
  travel.does.event(-1);
  expect(travel.whereabouts().time).toBe(20);
  travel.does.hide(new Set(["bookmark"]));
  travel.does.event(1);
  expect(travel.get("wanted")).toBeNull();
});

test("the list closes where moments are looked for, and another session's bookmarks are forgotten", async () => {
  travelOf(session).set("isFinding", true);
  list.toggle();
  expect(list.get("isOpen")).toBe(true);
  expect(travelOf(session).get("isFinding")).toBe(false);
  await list.mark();
  session.model.set("welcome", create(WelcomeSchema, { client: 3, session: "another" }));
  expect(list.get("editing")).toBeNull();
});
