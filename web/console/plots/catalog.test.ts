import { describe, expect, it } from "vitest";
import { searchEntries, seriesFor, subjectsOf, whoOf } from "./catalog.ts";
import { seriesFromJson, seriesKey, seriesLabel } from "./series.ts";

const port = (path: string, isNumber = true) => ({ path, unit: "m", help: `about ${path}`, isNumber });
const kRoster = {
  robots: [
    { id: 2, type: "ROBOT", unit: "left", program: 0 },
    { id: 1, type: "ROBOT", unit: "left", program: 0 },
    { id: 3, type: "scout", unit: "", program: 0xffffffff },
  ],
  units: [{ name: "left", members: [1, 2] }],
  programs: [
    { name: "a", ports: [port("wander.gain"), port("state", false), port("avoid.gain")] },
    { name: "b", ports: [port("avoid.gain")] },
  ],
};

describe("catalog", () => {
  it("offers quantities, then each number port once", () => {
    const ports = subjectsOf(kRoster).filter((s) => s.quantity === "port");
    expect(ports.map((p) => p.port)).toEqual(["avoid.gain", "wander.gain"]);
    expect(subjectsOf(kRoster)[0]?.label).toBe("Distance to goal");
  });

  it("offers units, then robots by number", () => {
    expect(whoOf(kRoster).map((w) => w.label)).toEqual(["left", "Robot 1", "Robot 2", "Robot 3"]);
  });

  it("finds entries by all words, in any order and case", () => {
    const found = searchEntries(subjectsOf(kRoster), "GAIN avoid", (s) => [s.label, s.help]);
    expect(found.map((s) => s.port)).toEqual(["avoid.gain"]);
    expect(searchEntries([1, 2], "  ", () => [])).toEqual([1, 2]);
  });

  it("spreads a port over the robots of a unit, skips robots without it and what is there", () => {
    const subject = subjectsOf(kRoster).filter((s) => s.port === "avoid.gain");
    const made = seriesFor(kRoster, subject, whoOf(kRoster), [
      { quantity: "port", robot: 2, unit: "", port: "avoid.gain" },
    ]);
    expect(made.map(seriesKey)).toEqual(["r1/port/avoid.gain"]);
  });

  it("plots a quantity of a unit as one line", () => {
    const speed = subjectsOf(kRoster).filter((s) => s.quantity === "speed");
    const made = seriesFor(kRoster, speed, whoOf(kRoster).slice(0, 2), []);
    expect(made.map(seriesLabel)).toEqual(["left: Speed", "Robot 1: Speed"]);
  });
});

describe("seriesFromJson", () => {
  it("reads back what was kept, once each", () => {
    const all = [
      { quantity: "speed", robot: 1, unit: "", port: "" },
      { quantity: "port", robot: 2, unit: "", port: "a.b" },
      { quantity: "formation_error", robot: 0, unit: "left", port: "" },
    ] as const;
    expect(seriesFromJson(JSON.parse(JSON.stringify([...all, all[0]])))).toEqual(all);
  });
  it("leaves out what is no series", () => {
    expect(seriesFromJson("x")).toEqual([]);
    expect(
      seriesFromJson([
        null,
        3,
        {},
        { quantity: "speed" },
        { quantity: "port", unit: "left", port: "p" },
        { quantity: "no", robot: 1 },
      ]),
    ).toEqual([]);
  });
});
