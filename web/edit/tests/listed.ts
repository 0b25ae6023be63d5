// What the list of tests says, as people read it.
import { type TestList, TestList_State, type TestList_Test } from "../../designer/session/protocol.ts";
import { count } from "../../ui/words/format.ts";

export const kStateWords: Readonly<Record<TestList_State, string>> = {
  [TestList_State.NOT_RUN]: "Not run",
  [TestList_State.RUNNING]: "Runs",
  [TestList_State.PASSED]: "Passed",
  [TestList_State.FAILED]: "Failed",
  [TestList_State.CANT_RUN]: "Can't run",
};

const kStateNames: Readonly<Record<TestList_State, string>> = {
  [TestList_State.NOT_RUN]: "not-run",
  [TestList_State.RUNNING]: "running",
  [TestList_State.PASSED]: "passed",
  [TestList_State.FAILED]: "failed",
  [TestList_State.CANT_RUN]: "cant-run",
};

/** For styles. */
export function stateName({ state, isOutdated }: TestList_Test): string {
  return `${kStateNames[state]} ${isOutdated && state !== TestList_State.RUNNING ? "outdated" : ""}`;
}

/** `4 tests: 3 passed, 1 failed`. */
export function summary(list: TestList | undefined): string {
  const tests = list?.tests ?? [];
  if (tests.length === 0) return "";
  const of = (state: TestList_State) => tests.filter((one) => one.state === state).length;
  const parts = [
    [of(TestList_State.RUNNING), "running"],
    [of(TestList_State.PASSED), "passed"],
    [of(TestList_State.FAILED), "failed"],
    [of(TestList_State.CANT_RUN), "can't run"],
  ] as const;
  const told = parts.filter(([n]) => n > 0).map(([n, word]) => `${n} ${word}`);
  return `${count(tests.length, "test")}${told.length > 0 ? `: ${told.join(", ")}` : ", not run yet"}`;
}

/** Those whose result is not that of the text as it stands. */
export function dueTests(list: TestList | undefined): TestList_Test[] {
  return (list?.tests ?? []).filter(({ state, isOutdated }) => isOutdated || state === TestList_State.NOT_RUN);
}

export function isRunning(list: TestList | undefined): boolean {
  return (list?.tests ?? []).some(({ state }) => state === TestList_State.RUNNING);
}

/** Whether C++ would have to be compiled and started for them. */
export function bringsCode(list: TestList | undefined): boolean {
  return (list?.tests ?? []).some((test) => test.bringsCode);
}

/** One of the list: in a text with a slip a name may stand there twice. */
export function keyOf({ test, line }: TestList_Test): string {
  return `${test?.file} ${line} ${test?.name}`;
}
