// Tests among all that can be done: in the list of commands, and by keys.
import type { Action } from "../../designer/session/action.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { kCycleBackKey, kCycleOnKey, kRunTestsKey } from "./keys.ts";
import { canStep, testsOf } from "./tests.ts";

export function testActions(designer: Designer): Action[] {
  const { document } = designer;
  if (!document) return [];
  const tests = testsOf(designer);
  const { shown } = tests.store.getState();
  const listed = tests.list?.tests.length ?? 0;
  const none = "No test is shown";
  return [
    {
      id: "run-tests",
      label: "Run all tests",
      group: "Run",
      shortcut: kRunTestsKey,
      blocked: designer.state.shown.tests && listed === 0 ? "There are no tests yet" : undefined,
      run: () => {
        if (designer.state.shown.tests) void tests.runAll();
        else designer.show({ tests: true });
      },
    },
    {
      id: "new-test",
      label: "New test",
      group: "Edit",
      blocked: document.isReadOnly ? "This can't be changed" : undefined,
      run: () => {
        designer.show({ tests: true });
        void tests.write();
      },
    },
    {
      id: "test-cycle-back",
      label: "One cycle of the test back",
      group: "Run",
      shortcut: kCycleBackKey,
      blocked: shown ? (canStep(shown, -1) ? undefined : "This is its first cycle") : none,
      run: () => void tests.step(-1),
    },
    {
      id: "test-cycle-on",
      label: "One cycle of the test on",
      group: "Run",
      shortcut: kCycleOnKey,
      blocked: shown ? (canStep(shown, 1) ? undefined : "This is its last cycle") : none,
      run: () => void tests.step(1),
    },
    {
      id: "test-cycle-end",
      label: "End showing the test",
      group: "Run",
      blocked: shown ? undefined : none,
      run: () => tests.close(),
    },
  ];
}
