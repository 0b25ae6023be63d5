import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Model } from "../../core/model.ts";
import { RosterSchema, StatusSchema } from "../../core/protocol.ts";
import { Flag, Life, RobotTable } from "../../core/robots.ts";
import { RosterIndex } from "../../core/roster.ts";
import { robotState, shownState, silenceOf } from "./robot_state.ts";
import { rosterRows, selectedKeys, selectionOf } from "./rows.ts";

const roster = new RosterIndex(
  create(RosterSchema, {
    robots: [1, 2, 3, 4, 5].map((id) => ({ id, type: id === 5 ? "lorry" : "scout" })),
    units: [
      { name: "scouts", parent: -1, members: [1, 2, 3, 4] },
      { name: "left", parent: 0, members: [1, 2] },
      { name: "right", parent: 0, members: [3, 4] },
    ],
  }),
);
const keys = (query: string, folded: string[] = []) => rosterRows(roster, query, new Set(folded)).map((row) => row.key);

it("tells how old what is shown of a robot is whose machine is silent", () => {
  const status = create(StatusSchema, { silentMachines: [{ name: "north", silent: 22.4, robots: [1, 3] }] });
  expect(silenceOf(status, 3)).toMatchObject({
    word: "Silent 22 s",
    tone: "",
    title: expect.stringContaining("north"),
  });
  expect(silenceOf(status, 2)).toBeNull();
  expect(silenceOf(undefined, 1)).toBeNull();
});

it("shows how old a robot's state is in place of it where its machine is silent, though it ran when it was heard", () => {
  const records = new Uint8Array(32);
  const view = new DataView(records.buffer);
  [1, 2].forEach((id, i) => {
    view.setUint32(16 * i, id, true);
    view.setUint8(16 * i + 14, Life.RUNNING);
  });
  const robots = new RobotTable();
  robots.accept(records);
  const status = create(StatusSchema, { silentMachines: [{ name: "north", silent: 3.2, robots: [1] }] });
  const model = new Model();
  const seen = { robots, get: ((part) => (part === "status" ? status : model.get(part))) as Model["get"] };
  expect(shownState(seen, 1)).toMatchObject({ word: "Silent 3 s", tone: "" });
  expect(shownState(seen, 2)).toEqual({ word: "Running", tone: "go" });
});

describe("the list of units and robots", () => {
  it("shows units with what is in them, and loose robots at the end", () => {
    expect(keys("")).toEqual(["u:scouts", "u:left", "r:1", "r:2", "u:right", "r:3", "r:4", "r:5"]);
  });
  it("finds a robot and keeps the units above it", () =>
    expect(keys("scout 3")).toEqual(["u:scouts", "u:right", "r:3"]));
  it("shows all of a unit that is found", () => expect(keys("left")).toEqual(["u:scouts", "u:left", "r:1", "r:2"]));
  it("finds by type", () => expect(keys("lorry")).toEqual(["r:5"]));
  it("folds units away", () =>
    expect(keys("", ["left"])).toEqual(["u:scouts", "u:left", "u:right", "r:3", "r:4", "r:5"]));
  it("finds nothing where nothing is", () => expect(keys("zzz")).toEqual([]));
});

describe("selecting in the list", () => {
  it("takes one unit as a unit, and more as robots", () => {
    expect(selectionOf(["u:left"], roster)).toMatchObject({ unit: "left", robots: [1, 2] });
    expect(selectionOf(["u:left", "r:5"], roster)).toMatchObject({ unit: "", robots: [1, 2, 5] });
    expect(selectionOf([], roster).robots).toEqual([]);
  });
  it("marks what is selected", () => {
    expect(selectedKeys(selectionOf(["u:left"], roster))).toEqual(["u:left"]);
    expect(selectedKeys(selectionOf(["r:3", "r:4"], roster))).toEqual(["r:3", "r:4"]);
  });
});

describe("a robot's state", () => {
  it("says the worst first", () => {
    expect(robotState(Life.RUNNING | Flag.STUCK | Flag.CONTACT).word).toBe("In contact");
    expect(robotState(Life.FAULTED | Flag.DONE).word).toBe("Faulted");
    expect(robotState(Life.RUNNING | Flag.DONE).word).toBe("Done");
    expect(robotState(Life.RUNNING).word).toBe("Running");
    expect(robotState(0).word).toBe("Not started");
  });
});
