import { expect, test } from "vitest";
import { kResult } from "../session/protocol.ts";
import { endOf, fitKeys } from "./wiring.ts";

test("the end of a wire is known by its id", () => {
  expect(endOf("cooperate.sum/members[2]")).toEqual({ node: "cooperate.sum", row: "members[2]" });
  expect(endOf("$movement/v")).toEqual({ node: "$movement", row: "v" });
  expect(endOf(kResult)).toEqual({ node: kResult, row: "value" });
});

test("fits are found by what they are about", () => {
  const list = {
    fits: [
      { node: "a", port: "x", index: 1, reason: "no" },
      { node: "b", port: "", reason: "" },
    ],
  };
  expect(fitKeys(list as Parameters<typeof fitKeys>[0])).toEqual(
    new Map([
      ["a/x[1]", "no"],
      ["b", ""],
    ]),
  );
});
