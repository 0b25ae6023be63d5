import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Log_EntrySchema, Log_Kind } from "../../core/protocol.ts";
import { filterLog, kEverything, windowOf } from "./filter.ts";

const log = [
  create(Log_EntrySchema, { number: 1n, kind: Log_Kind.STEP, text: "step 1 begins", unit: "scouts" }),
  create(Log_EntrySchema, {
    number: 2n,
    kind: Log_Kind.CONTACT,
    text: "touches an obstacle",
    robot: 3,
    unit: "scouts-1",
  }),
  create(Log_EntrySchema, { number: 3n, kind: Log_Kind.STATE, text: "go_to_goal", robot: 2 }),
];
const numbers = (filter: Partial<typeof kEverything>) =>
  filterLog(log, { ...kEverything, ...filter }).map((entry) => Number(entry.number));

describe("the filter of the log", () => {
  it("lets everything through at first", () => expect(numbers({})).toEqual([1, 2, 3]));
  it("looks for words in any order, also for kind and robot", () => {
    expect(numbers({ text: "obstacle robot 3" })).toEqual([2]);
    expect(numbers({ text: "CONTACT" })).toEqual([2]);
  });
  it("leaves kinds out", () => expect(numbers({ hidden: new Set([Log_Kind.STATE]) })).toEqual([1, 2]));
  it("shows some robots, or one unit", () => {
    expect(numbers({ robots: new Set([2]) })).toEqual([3]);
    expect(numbers({ unit: "SCOUTS" })).toEqual([1]);
  });
});

describe("the window of the log", () => {
  it("is what is in sight and a little more", () =>
    expect(windowOf(1000, 2600, 260, 26)).toEqual({ first: 94, end: 116 }));
  it("ends with the list", () => {
    expect(windowOf(3, 0, 260, 26)).toEqual({ first: 0, end: 3 });
    expect(windowOf(3, 9999, 260, 26).first).toBe(3);
    expect(windowOf(0, 0, 260, 26)).toEqual({ first: 0, end: 0 });
  });
});
