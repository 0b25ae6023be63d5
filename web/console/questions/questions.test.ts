import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import {
  Log_EntrySchema,
  Log_Kind,
  Questions_QuestionSchema,
  Status_Outcome,
  StatusSchema,
} from "../../core/protocol.ts";
import { openAlerts } from "../log/alerts.ts";
import { commandOfUnit, followedBy, isSameFollowing } from "../mission/unit_command.ts";
import { countdown } from "./countdown.ts";

describe("the countdown of a question", () => {
  const question = create(Questions_QuestionSchema, { id: 1, asked: 100, expires: 130 });
  it("counts simulated time, and says how long that is here", () => {
    const status = create(StatusSchema, { speedReached: 10 });
    expect(countdown(question, 110, status)).toEqual({ left: 20, share: 20 / 30, wallLeft: 2 });
  });
  it("takes for ever while time stands still", () => {
    expect(countdown(question, 110, null)?.wallLeft).toBe(Number.POSITIVE_INFINITY);
  });
  it("is not there where the question waits for a person", () => {
    expect(countdown(create(Questions_QuestionSchema, { id: 1 }), 110, null)).toBeUndefined();
  });
  it("never goes below nothing", () => expect(countdown(question, 500, null)?.left).toBe(0));
});

describe("what a unit is doing", () => {
  it("is its newest command under way", () => {
    const status = create(StatusSchema, {
      steps: [
        { commands: [{ unit: "a", text: "UNIT a MOVETO X", outcome: Status_Outcome.DONE }] },
        { commands: [{ unit: "a", text: "UNIT a OCCUPY Y", outcome: Status_Outcome.UNDER_WAY }] },
      ],
    });
    expect(commandOfUnit(status, "a")).toBe("OCCUPY Y");
    expect(commandOfUnit(status, "b")).toBe("");
  });
  it("is told with what it waits for, or how many robots are left", () => {
    const command = { unit: "a", text: "unit a MOVETO X", outcome: Status_Outcome.UNDER_WAY };
    const held = { ...command, isHeld: true, waitsFor: "the order `robot 1 MOVETO Y`" };
    expect(commandOfUnit(create(StatusSchema, { steps: [{ commands: [held] }] }), "a")).toBe(
      "MOVETO X waits for the order `robot 1 MOVETO Y`",
    );
    const order = { unit: "a", text: "unit a MOVETO Y", outcome: Status_Outcome.UNDER_WAY };
    expect(commandOfUnit(create(StatusSchema, { steps: [{ commands: [order] }, { commands: [held] }] }), "a")).toBe(
      "MOVETO Y",
    );
    const left = { ...command, followers: [2] };
    expect(commandOfUnit(create(StatusSchema, { steps: [{ commands: [left] }] }), "a")).toBe("MOVETO X, 1 robot left");
  });
});

describe("what a robot follows", () => {
  it("is its unit's command, or the order that names it", () => {
    const under = Status_Outcome.UNDER_WAY;
    const status = create(StatusSchema, {
      steps: [
        { commands: [{ unit: "a", text: "unit a MOVETO X", outcome: under, followers: [1] }] },
        { commands: [{ unit: "robots 2, 3", text: "robots 2, 3 OCCUPY Y (Line)", outcome: under, followers: [2, 3] }] },
        { commands: [{ unit: "b", text: "unit b MOVETO Z", outcome: under }] },
      ],
    });
    const followed = followedBy(status, (unit) => (unit === "b" ? [4] : []));
    expect(followed.get(1)).toEqual({ unit: "a", order: "MOVETO X" });
    expect(followed.get(3)).toEqual({ unit: "robots 2, 3", order: "OCCUPY Y (Line)" });
    expect(followed.get(4)?.order).toBe("MOVETO Z");
    expect(followed.has(5)).toBe(false);
  });
  it("is followed alike as long as each robot follows the same", () => {
    const one = new Map([[1, { unit: "a", order: "MOVETO X" }]]);
    expect(isSameFollowing(one, new Map([[1, { unit: "a", order: "MOVETO X" }]]))).toBe(true);
    expect(isSameFollowing(one, new Map([[1, { unit: "a", order: "MOVETO Y" }]]))).toBe(false);
    expect(isSameFollowing(one, new Map([[2, { unit: "a", order: "MOVETO X" }]]))).toBe(false);
    expect(isSameFollowing(one, new Map())).toBe(false);
  });
});

describe("alerts", () => {
  const entry = (number: bigint, robot: number, kind = Log_Kind.STUCK) =>
    create(Log_EntrySchema, { number, robot, kind, isAlert: true });
  it("of the same robot are shown once, as the newest", () => {
    expect(openAlerts([entry(1n, 3), entry(2n, 4), entry(3n, 3)], 0n, new Set()).map((one) => one.number)).toEqual([
      2n,
      3n,
    ]);
  });
  it("stay away once dismissed", () => {
    expect(openAlerts([entry(1n, 3), entry(2n, 4)], 0n, new Set([2n])).map((one) => one.number)).toEqual([1n]);
    expect(openAlerts([entry(1n, 3), entry(2n, 4)], 2n, new Set())).toEqual([]);
  });
  it("are not other entries", () => {
    expect(openAlerts([create(Log_EntrySchema, { number: 1n })], 0n, new Set())).toEqual([]);
  });
});
