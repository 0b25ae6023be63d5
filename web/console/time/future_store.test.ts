import { create } from "@bufbuild/protobuf";
import { beforeEach, expect, test } from "vitest";
import type { Connection } from "../../core/connection.ts";
import { Model } from "../../core/model.ts";
import { ChangeableSchema, ClientsSchema, type Order, ReplySchema, WelcomeSchema } from "../../core/protocol.ts";
import type { Session } from "../session/session.ts";
import { Ui } from "../session/ui.ts";
import { type FutureStore, futureOf, readLength } from "./future_store.ts";

let session: Session;
let store: FutureStore;
let asked: Order[];

beforeEach(() => {
  const model = new Model();
  const ui = new Ui(model, window.localStorage, { width: 1600, height: 1000 });
  asked = [];
  const ask = (order: Order) => {
    asked.push(order);
    const robot = order.case === "readChangeable" ? (order.value.robot ?? 0) : 0;
    const changeable = create(ChangeableSchema, { texts: [{ path: "a/b.cdl", text: `of ${robot}` }] });
    return Promise.resolve(create(ReplySchema, { ok: true, result: { case: "changeable", value: changeable } }));
  };
  session = { model, ui, connection: { ask } as unknown as Connection };
  store = futureOf(session);
  model.set("welcome", create(WelcomeSchema, { client: 1 }));
  operator(1);
});

const operator = (id: number) => session.model.set("clients", create(ClientsSchema, { operator: id }));
const first = () => store.get("changes")[0]!.id;
const last = () => store.get("changes").at(-1)!.id;

test("a length is typed as every other time of a run", () => {
  expect(["", "90", "1:30", "1:02:03", "2 min", "0:00.5"].map(readLength)).toEqual([0, 90, 90, 3723, 120, 0.5]);
  for (const text of ["soon", "2:75", "-3", "0", "1e3", "2:00:01"])
    expect(readLength(text), text).toBe(`“${text}” is no time: enter 90, 1:30 or 1:02:03, at most two hours.`);
});

test("several changes are asked for at once, in their order", () => {
  store.alter(first(), { port: "speed", value: " 2 ", target: "3" });
  store.add();
  store.alter(last(), { kind: "order", order: "UNIT scouts STOP" });
  store.add();
  store.alter(last(), { kind: "text", path: "a/b.cdl", text: "other" });
  store.set("length", "1:30");
  expect(store.wish(7)).toEqual({
    cycle: 7n,
    seconds: 90,
    withoutPeople: false,
    changes: [
      { what: { case: "parameter", value: { robots: [3], port: "speed", value: "2" } } },
      { what: { case: "order", value: "UNIT scouts STOP" } },
      { what: { case: "text", value: { path: "a/b.cdl", text: "other" } } },
    ],
  });
  store.remove(first());
  store.remove(first());
  store.remove(first());
  expect(store.wish(7)).toMatchObject({ changes: [] });
});

test("what is missing is said with the change that lacks it", () => {
  expect(store.wish(7)).toBe("Choose a parameter.");
  store.alter(first(), { kind: "order", order: "UNIT scouts STOP" });
  store.add();
  expect(store.wish(7)).toBe("Change 2: Enter an order, as UNIT scouts STOP.");
  store.alter(last(), { kind: "text", path: "a/b.cdl" });
  store.add();
  store.alter(last(), { path: "a/b.cdl" });
  expect(store.wish(7)).toBe("b.cdl is changed twice: remove one of the changes.");
});

test("who only watches is told at once that no design can be changed", async () => {
  store.alter(first(), { kind: "text", path: "a/b.cdl" });
  expect(store.whyNot).toBeUndefined();
  operator(2);
  expect(store.whyNot).toBe("Only the operator can change a design: take control first.");
  await store.compute(7);
  expect(asked).toEqual([]);
  store.alter(first(), { kind: "order" });
  expect(store.whyNot).toBeUndefined();
});

test("each robot whose parameters are changed is asked about once", async () => {
  store.alter(first(), { target: "2" });
  store.add();
  store.add();
  store.alter(last(), { target: "5" });
  await store.readChangeable(7);
  expect(asked.map((order) => (order.case === "readChangeable" ? order.value.robot : undefined))).toEqual([2, 5]);
  expect(store.changeableOf(store.get("changes")[2]!)?.texts[0]?.text).toBe("of 5");
  expect(store.texts().length).toBe(1);
});
