import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import {
  FailsafeStandingsSchema,
  FailsafesSchema,
  FailsafeTrialSchema,
  FailsafeStandings_State as State,
  Failsafes_Row_Watch as Watch,
  FailsafeTrial_What as What,
} from "../../core/protocol.ts";
import {
  askable,
  type Draft,
  fences,
  firstDraft,
  firstFence,
  firstSeconds,
  fitted,
  labelOf,
  limitsOf,
  type OwnRow,
  orderOf,
  ownRows,
  wrongIn,
} from "./conditions.ts";
import {
  doesText,
  measureText,
  nameOf,
  operandOf,
  standingText,
  stateWord,
  summaryText,
  thresholdText,
  worstOf,
  worstState,
} from "./standings.ts";
import { kept, keyOf, kNothingTried, kUnderWay } from "./trying.ts";
import { doing, ending, lineText, moments, notMet, verdict } from "./what_if.ts";

const { rows, bounds } = create(FailsafesSchema, {
  bounds: { seconds: 600, speed: 50, depth: 1000, bearing: 2 * Math.PI },
  rows: [
    { statement: "FAILSAFE OUTSIDE Field HOLD", condition: "OUTSIDE", fence: "Field", action: "HOLD" },
    {
      statement: "FAILSAFE LINK-LOST AFTER 5 RETURN",
      condition: "LINK-LOST",
      mayLast: true,
      seconds: 5,
      action: "RETURN",
      does: "it drives home",
      watch: Watch.REAL_TIME,
    },
    { statement: "FAILSAFE IN-CONTACT AFTER 0 HOLD", condition: "IN-CONTACT", mayLast: true, action: "HOLD" },
  ],
});
const limits = limitsOf(bounds ?? null);
const [fence, link, contact] = rows as [(typeof rows)[0], (typeof rows)[0], (typeof rows)[0]];
const standing = (state: State, used = 0, measure = 0) => ({ state, used, measure });
const standings = (...states: State[]) => create(FailsafeStandingsSchema, { rows: states.map((one) => standing(one)) });
const first = (state: State, used = 0, measure = 0) =>
  create(FailsafeStandingsSchema, { rows: [standing(state, used, measure)] }).rows[0]!;

describe("how a row stands", () => {
  it("has a word of its own for each state", () => {
    const all = Object.values(State).filter((state) => typeof state === "number");
    expect(new Set(all.map((state) => stateWord(state as State).word)).size).toBe(7);
  });
  it("says how much of what it takes is used up", () => {
    expect(standingText(link, first(State.NEAR, 62, 31), true)).toBe("3.1 of 5 s");
    expect(measureText(fence, 12.34)).toBe("12.3 m to the line");
    expect(measureText(fence, -0.4)).toBe("0.4 m beyond the line");
    expect(measureText(fence, 214)).toBe("214 m to the line");
    expect([measureText(contact, 0), measureText(link, 0)]).toEqual(["not now", "not now"]);
    expect(measureText(contact, 1.24)).toBe("for 1.2 s");
    expect([4.9, 5, 36.3].map((measure) => measureText(link, measure))).toEqual([
      "4.9 of 5 s",
      "for 5 s",
      "for 36.3 s",
    ]);
  });
  it("says why nobody looks at it", () => {
    expect(standingText(link, first(State.OFF), false)).toBe("looked at in real time only");
    expect(standingText(link, first(State.OFF), true)).toBe("looked at while the robot runs");
    expect(standingText(fence, first(State.OFF), false)).toBe("looked at while the robot runs");
    const steered = { ...link, watch: Watch.TELEOPERATED };
    expect(standingText(steered, first(State.OFF), false)).toBe("looked at under teleoperation only");
  });
  it("says of a battery how much is left of it, and that nobody knows", () => {
    const below = { ...link, condition: "BATTERY", share: 0.3, watch: Watch.VEHICLE };
    expect(operandOf(below)).toBe("BELOW 30%");
    expect(rows.map(operandOf)).toEqual(["Field", "", ""]);
    expect(standingText(below, first(State.ARMED, 50, 642), false)).toBe("64.2 % left");
    expect(standingText(below, first(State.ACTIVE, 100, -1000), false)).toBe("not known, which counts as empty");
    expect(standingText(below, first(State.OFF), false)).toBe("looked at of vehicles that are driven only");
  });
  it("says why it does not act though it is met", () => {
    expect(standingText(link, first(State.WAITING, 100, 60), true)).toBe("for 6 s, a row above it acts");
    expect(standingText(link, first(State.OVERRULED, 100, 60), true)).toMatch(/the stick has taken over$/);
    expect(standingText(fence, first(State.OVERRULED, 100, -20), true)).toBe(
      "2.0 m beyond the line, it may only drive nearer",
    );
  });
  it("says how long it takes, where it does", () => {
    expect(rows.map(thresholdText)).toEqual(["", "after 5 s", ""]);
    expect(nameOf(link)).toBe("LINK-LOST AFTER 5 RETURN");
  });
  it("says what becomes of the robot, which a fence holds whatever its row says", () => {
    expect(doesText(link)).toBe("it drives home");
    const goesOn = { ...link, action: "CONTINUE", does: "it goes on" };
    expect(doesText(goesOn)).toBe("it goes on");
    expect(doesText({ ...goesOn, condition: "OUTSIDE", fence: "Field" })).toMatch(
      /but for the way out: the fence holds$/,
    );
  });
  it("is told of several robots by the one that is worst off", () => {
    const all = new Map([
      [1, standings(State.ARMED, State.OTHERS)],
      [2, standings(State.ACTIVE, State.OTHERS)],
      [3, standings(State.ARMED, State.OFF)],
    ]);
    expect(worstOf(0, [1, 2, 3], all)).toMatchObject({ robot: 2, alike: 1, of: 3 });
    expect(worstOf(0, [1, 3], all)).toMatchObject({ robot: 1, alike: 2, of: 2 });
    expect(worstOf(1, [1, 2, 3], all)).toMatchObject({ robot: 3, of: 1 });
    expect(worstOf(1, [1, 2], all)).toBeUndefined();
    expect(worstOf(0, [9], all)).toBeUndefined();
  });
  it("is summed up, the worst first", () => {
    expect(summaryText(standings(State.ARMED, State.NEAR, State.ARMED, State.OTHERS))).toBe("1 near, 2 armed");
    expect(summaryText(undefined)).toBe("");
    expect(worstState(standings(State.ARMED, State.NEAR))).toBe(State.NEAR);
    expect(worstState(undefined)).toBe(State.OTHERS);
  });
});

describe("what is asked of the table", () => {
  const all = ownRows(rows, undefined);
  const own = (...some: OwnRow["row"][]) => some.map((row, index) => ({ index, row }));
  const at: NonNullable<Draft["fence"]> = { row: 0, side: "outside", distance: "2", bearing: "180", beginsThere: true };
  it("begins with what the first row is met by", () => {
    expect(firstDraft(all, limits).fence).toMatchObject({ row: 0, side: "inside" });
    expect(firstDraft(own(link), limits).lasting).toEqual({ "LINK-LOST": "6" });
    expect(firstDraft([], limits).lasting).toEqual({});
    expect(firstSeconds(own(link, { ...link, seconds: 30.5 }), "LINK-LOST", limits)).toBe("32");
  });
  it("is what the table has conditions for", () => {
    expect(askable(all)).toEqual(["LINK-LOST", "IN-CONTACT"]);
    expect(askable(all).map(labelOf)).toEqual(["Link lost", "In contact"]);
    expect(fences(all)).toEqual([["0", "1. Field"]]);
  });
  it("is of rows that guard the robot, and of no others", () => {
    const table = [{ ...fence, robots: "scout" }, link, { ...fence, fence: "Yard" }, { ...contact, robots: "scout" }];
    const known = ownRows(table, standings(State.OTHERS, State.OFF, State.ARMED, State.OTHERS));
    expect(fences(known)).toEqual([["2", "3. Yard"]]);
    expect(firstFence(known)).toMatchObject({ row: 2 });
    expect(firstDraft(known, limits)).toMatchObject({ lasting: { "LINK-LOST": "6" }, fence: null });
    expect(askable(known)).toEqual(["LINK-LOST"]);
    expect(ownRows(table, undefined).map(({ index }) => index)).toEqual([1, 2]);
    expect(ownRows(table, standings(State.OFF, State.OFF, State.OFF, State.OFF))).toHaveLength(4);
  });
  it("is kept for another robot as far as rows of its own go", () => {
    const draft: Draft = { lasting: { "LINK-LOST": "7", "IN-CONTACT": "1" }, fence: at, speed: "3" };
    const yard = { index: 2, row: { ...fence, fence: "Yard" } };
    expect(fitted(draft, all)).toEqual(draft);
    expect(fitted(draft, [yard, { index: 3, row: link }])).toEqual({
      lasting: { "LINK-LOST": "7" },
      fence: { ...at, row: 2 },
      speed: "3",
    });
    expect(fitted(draft, own(contact))).toEqual({ lasting: { "IN-CONTACT": "1" }, fence: null, speed: "3" });
  });
  it("goes to the server in metres, seconds and radians", () => {
    expect(orderOf(7, { lasting: { STUCK: "3" }, fence: at, speed: "2,5" }, limits)).toEqual({
      robot: 7,
      lasting: [{ condition: "STUCK", seconds: 3 }],
      speed: 2.5,
      fence: { row: 0, depth: -2, bearing: Math.PI, beginsThere: true },
    });
    const inside = orderOf(7, { lasting: {}, fence: { ...at, side: "inside" }, speed: "1" }, limits);
    expect(inside?.fence).toMatchObject({ depth: 2, beginsThere: false });
    expect(orderOf(7, { lasting: {}, fence: null, speed: "1" }, limits)?.fence).toBeUndefined();
  });
  it("is nothing before the server has said what it takes", () => {
    expect(wrongIn({ lasting: {}, fence: null, speed: "1" }, limitsOf(null))).toEqual(["Speed"]);
  });
  it("does not go there while a number is wrong, which is named", () => {
    const fine: Draft = { lasting: { STUCK: "3" }, fence: at, speed: "2" };
    const bad: [Draft, string][] = [
      ...["", "NaN", "-1", "51", "fast"].map((speed): [Draft, string] => [{ ...fine, speed }, "Speed"]),
      ...["1001", "-5"].map((distance): [Draft, string] => [{ ...fine, fence: { ...at, distance } }, "Distance"]),
      ...["361", "-361"].map((bearing): [Draft, string] => [{ ...fine, fence: { ...at, bearing } }, "Heading"]),
      [{ ...fine, lasting: { STUCK: "601" } }, "Stuck"],
    ];
    for (const [draft, name] of bad) {
      expect(wrongIn(draft, limits)).toEqual([name]);
      expect(orderOf(1, draft, limits)).toBeUndefined();
    }
    expect(wrongIn(fine, limits)).toEqual([]);
    expect(wrongIn({ lasting: { "LINK-LOST": "x" }, fence: null, speed: "" }, limits)).toEqual(["Link lost", "Speed"]);
  });
});

describe("an answer", () => {
  const draft: Draft = { lasting: { "LINK-LOST": "6" }, fence: null, speed: "1" };
  const order = orderOf(1, draft, limits);
  const answered = {
    isUnderWay: false,
    answer: { of: keyOf(order), is: { trial: create(FailsafeTrialSchema, {}) } },
  };
  it("stands beside the conditions that it answers", () => {
    expect(kept(answered, keyOf(orderOf(1, { ...draft, speed: "1.0" }, limits)))).toBe(answered);
  });
  it("goes when conditions, robot or a number that is wrong make it another's", () => {
    for (const other of [
      orderOf(1, { ...draft, speed: "2" }, limits),
      orderOf(1, { ...draft, speed: "" }, limits),
      orderOf(1, { ...draft, lasting: {} }, limits),
      orderOf(2, draft, limits),
    ])
      expect(kept(answered, keyOf(other))).toEqual(kNothingTried);
  });
  it("is waited for alone", () => {
    expect(kUnderWay.answer).toBeNull();
    expect(kept(kUnderWay, keyOf(undefined))).toBe(kUnderWay);
  });
});

describe("what came of it", () => {
  const trial = create(FailsafeTrialSchema, {
    events: [
      { time: 0.1, row: 2, what: What.MET },
      { time: 0.1, row: 2, what: What.ACTS },
      { time: 5, row: 1, what: What.MET },
      { time: 5, row: 2, what: What.GIVES_WAY },
      { time: 5, row: 1, what: What.ACTS },
      { time: 8, row: 2, what: What.NOT_MET },
    ],
    rows: [standing(State.ARMED, 12), standing(State.ACTIVE, 100, 80), standing(State.ARMED, 100)],
    seconds: 31,
    drivenTo: 30.02,
    stood: 30.4,
  });
  it("is told in the order of time, what is met and acts at once in one line", () => {
    expect(moments(trial, rows).map(({ time, text, acts }) => [time, text, acts])).toEqual([
      [0.1, "IN-CONTACT AFTER 0 HOLD is met, and acts", true],
      [5, "LINK-LOST AFTER 5 RETURN is met, and acts", true],
      [5, "IN-CONTACT AFTER 0 HOLD gives way", false],
      [8, "IN-CONTACT AFTER 0 HOLD is no longer met", false],
    ]);
  });
  it("tells of a row that is over that alone", () => {
    const over = create(FailsafeTrialSchema, {
      events: [
        { time: 2, row: 2, what: What.NOT_MET },
        { time: 2, row: 2, what: What.IS_OVER },
        { time: 2, row: 1, what: What.NOT_MET },
      ],
    });
    expect(moments(over, rows).map(({ text }) => text)).toEqual([
      "IN-CONTACT AFTER 0 HOLD is over",
      "LINK-LOST AFTER 5 RETURN is no longer met",
    ]);
  });
  it("says which row acts, and what becomes of the robot", () => {
    expect(verdict(trial, rows)).toBe("LINK-LOST AFTER 5 RETURN acts.");
    expect(doing(trial, rows)).toBe("it drives home");
    expect(ending(trial)).toBe("From 30.4 s on it stands, 30.0 m from where it was.");
    expect(notMet(trial, rows)).toEqual(["OUTSIDE Field HOLD (12 %)"]);
  });
  it("tells of many rows of which nothing was in one line", () => {
    const armed = (...used: number[]) =>
      create(FailsafeTrialSchema, { rows: used.map((one) => standing(State.ARMED, one)) });
    const table = [link, link, fence, contact];
    expect(notMet(armed(0, 7, 0, 0), table)).toEqual(["LINK-LOST AFTER 5 RETURN (7 %)", "Rows 1, 3 and 4 (0 %)"]);
    expect(notMet(armed(0, 7, 0), table)).toHaveLength(3);
  });
  it("says that nothing acts, and that what acted is over", () => {
    const nothing = create(FailsafeTrialSchema, { rows: [standing(State.ARMED)], seconds: 1, speed: 1, drivenTo: 1 });
    expect(verdict(nothing, rows)).toBe("No row acts.");
    expect(doing(nothing, rows)).toBe("");
    expect(ending(nothing)).toBe("After 1 s it drives at 1.0 m/s, 1.0 m from where it was.");
    const over = create(FailsafeTrialSchema, {
      events: [
        { time: 0.1, row: 2, what: What.ACTS },
        { time: 2, row: 2, what: What.IS_OVER },
      ],
    });
    expect(verdict(over, rows)).toBe("IN-CONTACT AFTER 0 HOLD acts, and is over again.");
  });
  it("tells where it stands at a fence, that its program has ended, and that nobody looked further", () => {
    const stopped = create(FailsafeTrialSchema, {
      stood: 2,
      lastRoom: 0.31,
      hasStopped: true,
      isCut: true,
      drivenTo: 5,
    });
    expect(ending(stopped)).toBe(
      "From 2 s on it stands, 5.0 m from where it was, 0.3 m before the line. Its program has ended. " +
        "Nobody looked any further: that would be too much work.",
    );
    expect([lineText(-2), lineText(-5.8e-13), lineText(0.04), lineText(120)]).toEqual([
      "2.0 m beyond the line",
      "at the line",
      "at the line",
      "120 m before the line",
    ]);
  });
});
