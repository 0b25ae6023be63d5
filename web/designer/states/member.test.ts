import { expect, test } from "vitest";
import { memberOf, stateName } from "./member.ts";

test("a state calls what was chosen for it, or begins an operator", () => {
  expect(memberOf("Wander")).toBe("Wander()");
  expect(memberOf("cooperate")).toBe("cooperate {}");
  expect(memberOf("coordinate by WeightedSum")).toBe("coordinate by WeightedSum() {}");
  expect(memberOf("sequence")).toContain("start Waiting");
});

test("a state has a name that is free", () => {
  expect(stateName("Wander", [])).toBe("Wander");
  expect(stateName("compete by priority", ["Compete"])).toBe("Compete_2");
});
