import { expect, test } from "vitest";
import { Port_Role } from "../../core/protocol.ts";
import { choosePlace, guessPlaces, joined, witnessesOf } from "./places.ts";

const none = () => false;

test("a path stands before what is drawn, with a dot between", () => {
  expect(joined("movement.Searching", "Noise")).toBe("movement.Searching.Noise");
  expect(joined("", "Noise")).toBe("Noise");
  expect(joined("movement.Searching", ".")).toBe("movement.Searching");
});

test("who goes into a state's assemblage sees it where that state runs it", () => {
  const places = ["movement.Acquiring.KeepClear", "movement.Searching.KeepClear"];
  expect(choosePlace(places, { chosen: "", before: "movement.Searching", isActive: none })).toBe(places[1]);
});

test("else the place that is active is shown, and what somebody chose comes before all", () => {
  const places = ["a", "b", "c"];
  const isActive = (place: string) => place === "b";
  expect(choosePlace(places, { chosen: "", before: "x", isActive })).toBe("b");
  expect(choosePlace(places, { chosen: "c", before: "x", isActive })).toBe("c");
  expect(choosePlace(places, { chosen: "gone", before: "", isActive: none })).toBe("a");
  expect(choosePlace([], { chosen: "", before: "", isActive })).toBeUndefined();
});

test("whether a place runs is told by its value, or else by what it computes", () => {
  const output = (path: string) => ({ path, role: Port_Role.OUTPUT });
  const ports = [
    output("a"),
    output("a.Noise"),
    { path: "b.gain", role: Port_Role.PARAMETER },
    output("b.Noise"),
    output("b.Probe"),
  ];
  expect([...witnessesOf(["a", "b"], ports)]).toEqual([
    ["a", ["a"]],
    ["b", ["b.Noise", "b.Probe"]],
  ]);
  expect(witnessesOf(["a"], ports).size).toBe(0);
});

test("a page is found among ports by what is drawn on it", () => {
  const ports = ["movement.Searching.Noise", "movement.Searching.Probe", "movement.Delivering.Noise"];
  expect(guessPlaces(["Noise", "Probe", "."], ports)).toEqual(["movement.Searching"]);
  expect(guessPlaces(["Detect"], ports)).toEqual([]);
  expect(guessPlaces(["a"], ["a"])).toEqual([""]);
});
