import { expect, test } from "vitest";
import { spokenEnd, spokenPath } from "./port_words.ts";

test("a path is said by the names that people gave", () => {
  expect(spokenPath("movement.Searching.value.spread")).toBe("Searching: spread");
  expect(spokenPath("movement.Searching")).toBe("Searching");
  expect(spokenPath("movement.Searching.value.KeepClear.AvoidRobots")).toBe("Searching, KeepClear: AvoidRobots");
  expect(spokenPath("movement.Searching.Noise.output")).toBe("Searching: Noise");
  expect(spokenPath("value.Noise")).toBe("Noise");
  expect(spokenPath("movement.members[1].Noise")).toBe("Noise");
});

test("what is short already, or another actuator, stays", () => {
  expect(spokenPath("movement")).toBe("movement");
  expect(spokenPath("")).toBe("");
  expect(spokenPath("avoid_obstacles")).toBe("avoid_obstacles");
  expect(spokenPath("pantilt.LookAround")).toBe("pantilt: LookAround");
});

test("the end of a path says what is there", () => {
  expect(spokenEnd("movement.Searching.value.spread")).toBe("spread");
  expect(spokenEnd("movement.Searching")).toBe("Searching");
});
