import { expect, test } from "vitest";
import { readRecord } from "./stored.ts";

test("what is kept and is no record is as if nothing were kept", () => {
  expect([null, "", "{", "[1]", "null", "3", '"a"'].map(readRecord)).toEqual([{}, {}, {}, {}, {}, {}, {}]);
  expect(readRecord('{"a":1}')).toEqual({ a: 1 });
});
