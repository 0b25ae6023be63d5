// All tests that a configuration is about: how each ended, what was there instead of what was expected, and the way to it.
import { type TestList_Failure, TestList_State, type TestList_Test } from "../../designer/session/protocol.ts";
import { titleOf } from "../../designer/session/titles.ts";
import { useDesigner, useDocument, usePart } from "../../designer/session/use.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton, Switch } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { kRunTestsKey } from "./keys.ts";
import { bringsCode, isRunning, keyOf, kStateWords, stateName, summary } from "./listed.ts";
import { useTestList, useTests, useTestsPart } from "./use_tests.ts";

export function TestsHeader() {
  const designer = useDesigner();
  const tests = useTests();
  const list = useTestList();
  const chosen = useTestsPart((state) => state.runsAfterChange);
  const isReadOnly = useDocument()?.isReadOnly ?? false;
  const isEmpty = (list?.tests.length ?? 0) === 0;
  return (
    <>
      <h2>Tests</h2>
      <span className="muted small number tests-summary grow" role="status">
        {summary(list)}
      </span>
      {!isEmpty && (
        <>
          <Switch
            label="Run after each change"
            value={chosen ?? !bringsCode(list)}
            onChange={(value) => tests.setRunsAfterChange(value)}
          />
          {isRunning(list) ? (
            <Button icon="abort" onPress={() => void tests.stop()}>
              Stop
            </Button>
          ) : (
            <Hint text="Run all tests" shortcut={shownShortcut(kRunTestsKey)}>
              <Button tone="go" icon="play" onPress={() => void tests.runAll()}>
                Run all
              </Button>
            </Hint>
          )}
        </>
      )}
      <Button icon="plus" isDisabled={isReadOnly} onPress={() => void tests.write()}>
        New test
      </Button>
      <IconButton icon="close" label="Hide Tests" onPress={() => designer.show({ tests: false })} />
    </>
  );
}

export function TestsPanel() {
  const list = useTestList();
  if (!list?.isKnown) return <p className="empty small">Looking for tests…</p>;
  if (list.tests.length === 0) return <NoTests />;
  return (
    <>
      <ul className="test-list">
        {list.tests.map((test) => (
          <Entry key={keyOf(test)} test={test} />
        ))}
      </ul>
      {list.leftOut !== "" && <p className="empty small">{sentence(list.leftOut)}</p>}
    </>
  );
}

const kExample = `test "keeps off" of Careful() {
  given obstacle(at = [2 m, 0 m]);
  expect abs(direction(it)) > 90 deg;
}`;

function NoTests() {
  const tests = useTests();
  const isReadOnly = useDocument()?.isReadOnly ?? false;
  return (
    <div className="no-tests">
      <p>
        No tests yet. A test says what a component does when it senses this or that. It stands in the text, below the
        component or in a file of the project that uses it:
      </p>
      <pre>{kExample}</pre>
      {isReadOnly ? (
        <p className="muted small">This configuration can't be changed: make your own copy of it first.</p>
      ) : (
        <Button tone="primary" icon="plus" onPress={() => void tests.write()}>
          Write a first test
        </Button>
      )}
    </div>
  );
}

function Entry({ test }: { test: TestList_Test }) {
  const tests = useTests();
  const shown = useTestsPart((state) => state.shown);
  const document = usePart((state) => state.document);
  const name = test.test?.name ?? "";
  const file = test.test?.file ?? "";
  const isShown = shown?.test.name === name && shown.test.file === file;
  const hasRun = test.state === TestList_State.PASSED || test.state === TestList_State.FAILED;
  return (
    <li className={`test ${stateName(test)}`} aria-label={`${name}: ${kStateWords[test.state]}`}>
      <div className="test-line">
        <StateSign test={test} />
        <span className="test-name">
          <Button tone="link" onPress={() => test.at && tests.reveal(test.at)}>
            {name}
          </Button>
          <span className="muted small">
            of <Component test={test} />
            {file !== document && ` in ${titleOf(file)}`}
            {hasRun && `, ${test.cycles} ${test.cycles === 1 ? "cycle" : "cycles"}`}
            {test.isOutdated && hasRun && ", before the last change"}
          </span>
        </span>
        {hasRun && test.cycles > 0 && (
          <Button
            tone="quiet"
            icon="cycle"
            aria-label={`Show cycle ${cycleOf(test)} of ${name}`}
            aria-pressed={isShown}
            onPress={() => (isShown ? tests.close() : void tests.show(test, cycleOf(test)))}
          >
            {isShown ? "Shown" : `Show cycle ${cycleOf(test)}`}
          </Button>
        )}
        <IconButton
          icon="play"
          label={`Run ${name}`}
          isDisabled={test.state === TestList_State.RUNNING}
          onPress={() => void tests.run([test])}
        />
      </div>
      {test.state === TestList_State.FAILED && test.failure && <Failed failure={test.failure} />}
      {test.state === TestList_State.CANT_RUN && <CantRun test={test} />}
    </li>
  );
}

/** The one at which it failed, else its last. */
function cycleOf({ failure, cycles }: TestList_Test): number {
  return failure?.cycle || cycles;
}

function StateSign({ test }: { test: TestList_Test }) {
  const word = kStateWords[test.state];
  const icons = {
    [TestList_State.NOT_RUN]: "minus",
    [TestList_State.RUNNING]: "more",
    [TestList_State.PASSED]: "check",
    [TestList_State.FAILED]: "close",
    [TestList_State.CANT_RUN]: "warning",
  } as const;
  return (
    <span className="test-state">
      <Icon name={icons[test.state]} />
      <span className="test-word small">{word}</span>
    </span>
  );
}

/** What is tested; leads to its page where it has one. */
function Component({ test }: { test: TestList_Test }) {
  const tests = useTests();
  const { page, component } = test;
  if (!page || page.document === "") return <code>{component}</code>;
  return (
    <Button tone="link" className="test-component" onPress={() => tests.goToPage(page)}>
      <code>{component}</code>
    </Button>
  );
}

function Failed({ failure }: { failure: TestList_Failure }) {
  const tests = useTests();
  const { expected, reason, label, cycle, findings, place, line } = failure;
  return (
    <div className="test-failure">
      <p>
        <code>{expected}</code> {withoutBackticks(reason)} in cycle {cycle}
        {label !== "" && <span className="muted">, {withoutBackticks(label)}</span>}.{" "}
        {place && line > 0 && (
          <Button tone="link" onPress={() => tests.reveal(place)}>
            {titleOf(place.document)}, line {line}
          </Button>
        )}
      </p>
      {findings.length > 0 && (
        <ul className="test-findings small" aria-label="What was there">
          {findings.map((finding) => (
            <li key={finding}>
              <code>{finding}</code>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

function CantRun({ test: { why, trouble } }: { test: TestList_Test }) {
  const tests = useTests();
  return (
    <p className="test-failure">
      {sentence(why, withoutBackticks)}{" "}
      {trouble && trouble.document !== "" && (
        <Button tone="link" onPress={() => tests.reveal(trouble)}>
          Show where
        </Button>
      )}
    </p>
  );
}
