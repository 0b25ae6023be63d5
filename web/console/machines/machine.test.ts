import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Machines_MachineSchema, MachinesSchema, Machines_State as State } from "../../core/protocol.ts";
import { attention, clockText, condition, healthText, linkText, othersText, versionText } from "./machine.ts";

const machine = (said: object) => create(Machines_MachineSchema, { name: "north", version: "0.1.0", ...said });

describe("a machine of the fleet", () => {
  it("says how old all of it is that nothing is heard of", () => {
    expect(condition(machine({ state: State.SILENT, heard: 3.9, isStopped: true }))).toEqual({
      word: "Silent 3 s",
      tone: "",
      isOld: true,
    });
    expect(condition(machine({ state: State.GONE, heard: 400 }))).toMatchObject({
      word: "Gone, heard 6 min ago",
      isOld: true,
    });
    expect(condition(machine({}))).toEqual({ word: "There", tone: "go", isOld: false });
  });
  it("says that it is stopped, and whether it would forget that", () => {
    expect(condition(machine({ isStopped: true }))).toMatchObject({ word: "Stopped", tone: "danger" });
    expect(condition(machine({ isStopped: true, notKept: "disk full" })).word).toBe("Stopped, not kept");
  });
  it("tells its link and its clock where they were measured", () => {
    expect(linkText(machine({}))).toBe("not measured yet");
    expect(clockText(machine({ state: State.SILENT }))).toBe("–");
    const link = { roundTrip: 0.00123, clockOffset: -0.04, lost: 0.001, isClockKnown: true };
    expect(linkText(machine({ link }))).toBe("1.2 ms there and back, 1 % lost");
    expect(clockText(machine({ link }))).toBe("40 ms behind");
    expect(clockText(machine({ link: { ...link, clockOffset: 200 } }))).toBe("3 min ahead");
    expect(clockText(machine({ link: { ...link, isClockKnown: false } }))).toBe("the same");
  });
  it("tells robots of other runs, and that it has none", () => {
    expect(othersText(machine({ robots: [1, 2], carried: 5 }))).toBe("3 robots of other runs");
    expect(othersText(machine({ robots: [1], carried: 1 }))).toBe("");
    expect(othersText(machine({}))).toBe("none");
  });
  it("names the console's version where that is another one", () => {
    expect(versionText(machine({}), "0.1.0")).toBe("0.1.0");
    expect(versionText(machine({ offers: "forager" }), "0.2.0")).toBe(
      "0.1.0, which is not this console's 0.2.0, carries forager only",
    );
  });
  it("tells how much work it has", () =>
    expect(healthText(machine({ load: 0.44, processors: 2, freeMemory: 3n << 20n }))).toBe(
      "load 0.4 of 2 processors, 3 MB free",
    ));
});

it("counts machines that somebody ought to look at", () => {
  expect(attention(null)).toBe(0);
  const machines = [{}, { state: State.SILENT }, { state: State.GONE }, { state: State.GONE, robots: [1] }];
  expect(attention(create(MachinesSchema, { machines }))).toBe(2);
});
