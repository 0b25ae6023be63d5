import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { TestList_State, TestListSchema } from "../../designer/session/protocol.ts";
import { bringsCode, dueTests, isRunning, stateName, summary } from "./listed.ts";

const listOf = (...tests: { state: TestList_State; isOutdated?: boolean; bringsCode?: boolean }[]) =>
  create(TestListSchema, { isKnown: true, tests });

test("how all tests stand is told in a few words", () => {
  expect(summary(undefined)).toBe("");
  expect(summary(listOf())).toBe("");
  expect(summary(listOf({ state: TestList_State.NOT_RUN }))).toBe("1 test, not run yet");
  const { PASSED, FAILED, CANT_RUN } = TestList_State;
  expect(summary(listOf({ state: PASSED }, { state: FAILED }, { state: PASSED }, { state: CANT_RUN }))).toBe(
    "4 tests: 2 passed, 1 failed, 1 can't run",
  );
});

test("what was not run since the text changed is due", () => {
  const list = listOf(
    { state: TestList_State.PASSED },
    { state: TestList_State.FAILED, isOutdated: true },
    { state: TestList_State.NOT_RUN },
  );
  expect(dueTests(list)).toEqual([list.tests[1], list.tests[2]]);
  expect(isRunning(list)).toBe(false);
  expect(isRunning(listOf({ state: TestList_State.RUNNING }))).toBe(true);
});

test("one test with code of its own is enough to ask before all are run again and again", () => {
  expect(bringsCode(listOf({ state: TestList_State.NOT_RUN }))).toBe(false);
  expect(
    bringsCode(listOf({ state: TestList_State.NOT_RUN }, { state: TestList_State.PASSED, bringsCode: true })),
  ).toBe(true);
});

test("a result of another text looks otherwise, unless it is just found anew", () => {
  const { tests } = listOf(
    { state: TestList_State.PASSED, isOutdated: true },
    { state: TestList_State.RUNNING, isOutdated: true },
  );
  expect(tests.map(stateName)).toEqual(["passed outdated", "running "]);
});
