// How components get at tests and subscribe to them.
import { useStore } from "zustand";
import type { TestList } from "../../designer/session/protocol.ts";
import { useDesigner, usePart } from "../../designer/session/use.ts";
import { type Tests, type TestsState, testsOf } from "./tests.ts";

export function useTests(): Tests {
  return testsOf(useDesigner());
}

export function useTestsPart<T>(pick: (state: TestsState) => T): T {
  return useStore(useTests().store, pick);
}

/** Those that are listed; none: they are not known yet. */
export function useTestList(): TestList | undefined {
  const home = useTestsPart((state) => state.home);
  return usePart((state) => state.tests[home]);
}
