import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { exampleConditions, MomentFinder, neighbourMoment } from "./moment_finder.ts";
import { FoundSchema, type Order, type Reply, ReplySchema } from "./protocol.ts";

/** A server that finds something every 10 s, and looks through 25 s at a time. */
function server(end: number) {
  const asked: number[] = [];
  const ask = async (order: Order): Promise<Reply> => {
    if (order.case !== "findMoments") throw new Error("something else was asked");
    const from = order.value.from ?? 0;
    asked.push(from);
    if (order.value.condition === "nonsense")
      return create(ReplySchema, { ok: false, error: "`nonsense`: expected a robot" });
    const to = Math.min(end, Math.max(from, 0) + 25);
    const moments = [];
    for (let time = 10; time <= to; time += 10) if (time > from) moments.push({ time, text: `at ${time}` });
    return create(ReplySchema, {
      ok: true,
      result: { case: "found", value: create(FoundSchema, { moments, searchedTo: to, isAll: to >= end }) },
    });
  };
  return { asked, ask };
}

test("all moments of the run are found, piece by piece, each once", async () => {
  const { asked, ask } = server(100);
  const finder = new MomentFinder({ ask });
  const states: boolean[] = [];
  finder.subscribe("finding", () => states.push(finder.get("finding").isUnderWay));
  await finder.find(" any robot in contact ");
  expect(finder.get("finding")).toMatchObject({ condition: "any robot in contact", searchedTo: 100, isCut: false });
  expect(finder.get("finding").moments.map(({ time }) => time)).toEqual([10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
  expect(asked).toEqual([-1, 25, 50, 75]);
  expect(states).toEqual([true, true, true, true, false]);
});

test("what is not understood is said, and another condition can be tried", async () => {
  const { ask } = server(20);
  const finder = new MomentFinder({ ask });
  await finder.find("nonsense");
  expect(finder.get("finding")).toMatchObject({ isUnderWay: false, problem: "`nonsense`: expected a robot" });
  await finder.find("robot 1 stuck");
  expect(finder.get("finding")).toMatchObject({ problem: "" });
  expect(finder.get("finding").moments).toHaveLength(2);
});

test("a search that is cancelled keeps what it has found, and asks for nothing more", async () => {
  const { asked, ask } = server(1000);
  const finder = new MomentFinder({ ask });
  const done = finder.find("any robot in contact");
  finder.subscribe("finding", () => {
    if (asked.length === 2) finder.cancel();
  });
  await done;
  expect(asked).toHaveLength(2);
  const { isUnderWay, isCut, moments } = finder.get("finding");
  expect({ isUnderWay, isCut }).toEqual({ isUnderWay: false, isCut: true });
  expect(moments.length).toBeGreaterThan(1);
});

test("a server that does not get on is not asked for ever", async () => {
  let asked = 0;
  const ask = async (): Promise<Reply> => {
    ++asked;
    return create(ReplySchema, { ok: true, result: { case: "found", value: create(FoundSchema) } });
  };
  const finder = new MomentFinder({ ask });
  await finder.find("any robot in contact");
  expect(asked).toBe(1);
  expect(finder.get("finding").isUnderWay).toBe(false);
});

test("the neighbours of a moment are those before and after it, never itself", () => {
  const moments = [{ time: 10 }, { time: 20 }, { time: 20 }, { time: 30 }];
  expect(neighbourMoment(moments, 20, 1)).toBe(30);
  expect(neighbourMoment(moments, 20, -1)).toBe(10);
  expect(neighbourMoment(moments, 10, -1)).toBeUndefined();
  expect(neighbourMoment(moments, 30.5, 1)).toBeUndefined();
  expect(neighbourMoment(moments, 30.5, -1)).toBe(30);
});

test("examples are of the robot that one looks at, and of a state that it has", () => {
  const conditions = exampleConditions(3, "Return").map(([condition]) => condition);
  expect(conditions).toContain("robot 3 in state Return");
  expect(new Set(conditions).size).toBe(conditions.length);
  expect(exampleConditions(3, "").length).toBe(conditions.length - 1);
});
