import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { PreflightSchema, Preflight_Result as Result } from "../../core/protocol.ts";
import { attention, groupsOf, kBlank, missingIn, orderOf, resultWord, tally, worstOf } from "./checklist.ts";

const checklist = create(PreflightSchema, {
  hasVehicles: true,
  isNeeded: true,
  lookedAt: 1,
  vehicles: [
    { name: "veh-1", kind: "MAVLink rover at udp:14550", isThere: true, robots: [1] },
    { name: "veh-2", kind: "veh-2", isSimulated: true, robots: [2, 3] },
  ],
  items: [
    { id: "mission/failsafes", name: "failsafes", result: Result.WARN, is: "none" },
    { id: "veh-1/link", vehicle: "veh-1", name: "link", result: Result.PASS, is: "2.1 ms there and back" },
    {
      id: "veh-1/battery",
      vehicle: "veh-1",
      name: "battery",
      result: Result.FAIL,
      is: "8 %",
      expected: "20 % or more",
    },
    { id: "veh-1/clock", vehicle: "veh-1", name: "clock", result: Result.UNKNOWN, is: "not told" },
  ],
  manual: [
    { id: "area-clear", text: "the area is clear" },
    { id: "stop-in-reach", text: "somebody has the stop in reach" },
  ],
});
const filled = {
  by: " Ada ",
  confirmed: new Set(["area-clear", "stop-in-reach", "gone"]),
  because: { "veh-1/battery": " it only goes ten metres ", "veh-1/link": "old" },
};

describe("the checklist", () => {
  it("is the mission's items, then each vehicle's, with the worst of each", () => {
    const groups = groupsOf(checklist, (robot) => `Robot ${robot}`);
    expect(groups.map(({ title }) => title)).toEqual(["The mission", "Vehicle veh-1", "Vehicle veh-2"]);
    expect(groups.map(({ worst }) => worst)).toEqual([Result.WARN, Result.FAIL, Result.PASS]);
    expect(groups.map(({ about }) => about)).toEqual([
      "",
      "MAVLink rover at udp:14550, body of Robot 1",
      "body of Robot 2 and Robot 3, simulated: nothing real moves",
    ]);
    expect(groups[1]?.items.map(({ name }) => name)).toEqual(["link", "battery", "clock"]);
  });
  it("is summed up, the worst first", () => {
    expect(tally(checklist.items)).toBe("1 failed, 1 warning, 1 unknown, 1 pass");
    expect(tally([])).toBe("");
    expect(worstOf([])).toBe(Result.PASS);
    const all = [Result.PASS, Result.WARN, Result.FAIL, Result.UNKNOWN];
    expect(new Set(all.map((result) => resultWord(result).word)).size).toBe(4);
  });
  it("wants somebody until it is signed, or where nobody has to", () => {
    expect(attention(checklist)).toBe(1);
    expect(attention({ ...checklist, items: [] })).toBe(1);
    expect(attention({ ...checklist, signedBy: "Ada" })).toBe(0);
    expect(attention({ ...checklist, isNeeded: false })).toBe(0);
    expect(attention(null)).toBe(0);
  });
});

describe("signing", () => {
  it("says what is missing", () => {
    expect(missingIn(checklist, kBlank)).toEqual([
      "1 item has failed, and no reason is given.",
      "2 items are not confirmed.",
      "Nobody's name stands below it.",
    ]);
    expect(missingIn(checklist, { ...filled, because: { "veh-1/battery": "  " } })).toHaveLength(1);
    expect(missingIn({ ...checklist, lookedAt: 0 }, filled)).toEqual(["The vehicles are still being looked at."]);
    expect(missingIn(checklist, filled)).toEqual([]);
  });
  it("is of what is there now: what was ticked or explained before and is gone goes nowhere", () => {
    expect(orderOf(checklist, filled)).toEqual({
      by: "Ada",
      confirmed: ["area-clear", "stop-in-reach"],
      accepted: [{ item: "veh-1/battery", because: "it only goes ten metres" }],
    });
  });
});
