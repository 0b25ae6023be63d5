// Says that what the drawing shows are values of a test and not of a robot, goes through its cycles, and ends it.
import { useEffect } from "react";
import { spokenPath } from "../../core/port_words.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Banner } from "../../ui/controls/banner.tsx";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { kCycleBackKey, kCycleOnKey } from "./keys.ts";
import { canStep, type ShownCycle, type Tests } from "./tests.ts";
import { useTests, useTestsPart } from "./use_tests.ts";

export function CycleBanner() {
  const tests = useTests();
  const shown = useTestsPart((state) => state.shown);
  return shown && <ShownBanner tests={tests} shown={shown} />;
}

function ShownBanner({ tests, shown }: { tests: Tests; shown: ShownCycle }) {
  useEffect(() => endByEscape(tests), [tests]);
  const { test, cycle, cycles, places, place, page } = shown;
  const isRead = shown.error === "" && cycles > 0;
  return (
    <Banner tone="accent">
      <Icon name="cycle" />
      <span className="grow test-cycle">
        Test “{test.name}”{isRead && ` at cycle ${cycle} of ${cycles}`}: values of the test, not of a robot.
        {shown.error !== "" && ` ${sentence(shown.error, withoutBackticks)}`}
        {isRead && places.length === 0 && " Nothing of this page runs in it."}
      </span>
      {isRead && places.length === 0 && page && page.document !== "" && (
        <Button onPress={() => tests.goToPage(page)}>Show {page.page}</Button>
      )}
      {places.length > 1 && (
        <Choice
          label="This page as it runs in"
          value={place}
          choices={places.map((one) => [one, spokenPath(one)] as const)}
          onChange={(chosen) => tests.choosePlace(chosen)}
        />
      )}
      <IconButton
        icon="rewind"
        label="One cycle back"
        shortcut={shownShortcut(kCycleBackKey)}
        isDisabled={!canStep(shown, -1)}
        onPress={() => void tests.step(-1)}
      />
      <IconButton
        icon="step"
        label="One cycle on"
        shortcut={shownShortcut(kCycleOnKey)}
        isDisabled={!canStep(shown, 1)}
        onPress={() => void tests.step(1)}
      />
      <IconButton
        icon="close"
        label="End showing the test"
        shortcut={shownShortcut("escape")}
        onPress={() => tests.close()}
      />
    </Banner>
  );
}

/** Before it takes back a selection; what pops up, and fields, keep their Escape. */
function endByEscape(tests: Tests): () => void {
  const pressed = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || tests.designer.state.dialog !== "") return;
    const isOfOther = "input, textarea, .cm-editor, [role=dialog], [role=menu], [role=listbox]";
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest(isOfOther) || document.querySelector("[role=menu], [role=listbox].popover")) return;
    event.preventDefault();
    event.stopPropagation();
    tests.close();
  };
  window.addEventListener("keydown", pressed, { capture: true });
  return () => window.removeEventListener("keydown", pressed, { capture: true });
}
