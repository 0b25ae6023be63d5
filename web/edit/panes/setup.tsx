// What runs, how many robots, in which surroundings, and where they start.
import { useState } from "react";
import { useDocument, usePart } from "../../designer/session/use.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { kMostRobots } from "../run/live_state.ts";
import { subjectOf, subjectsOf } from "../run/subject.ts";
import { useLivePage, useLiveState } from "./use_live_part.ts";

const kKinds: Readonly<Record<string, string>> = {
  robot: "a complete robot",
  society: "all of its robots",
  assemblage: "in a standard body",
};

export function Setup() {
  const live = useLivePage();
  const document = useDocument();
  const page = usePart((state) => state.page);
  const overlays = usePart((state) => state.hello?.overlays) ?? [];
  const { subject, robots, overlay, starts } = useLiveState((state) => state);
  const declarations = document?.declarations ?? [];
  const shown = subjectOf(declarations, subject, page);
  const isSociety = shown?.kind === "society";
  return (
    <div className="rows run-setup">
      <Choice
        label="What runs"
        value={shown?.name ?? ""}
        choices={subjectsOf(declarations).map(({ name, kind }) => [name, name, kKinds[kind] ?? kind] as const)}
        onChange={(next) => live.store.setState({ subject: next })}
      />
      <Count key={robots} value={robots} isDisabled={isSociety} set={(next) => live.store.setState({ robots: next })} />
      <Choice
        label="Surroundings"
        value={overlay === "" ? "$open" : overlay}
        choices={[
          ["$open", "An open field", "with some obstacles and objects"] as const,
          ...overlays.map(({ path, title }) => [path, title || path, path] as const),
        ]}
        onChange={(next) => live.store.setState({ overlay: next === "$open" ? "" : next })}
      />
      <div className="columns spread">
        <span className="small muted">
          {starts.length === 0
            ? "Robots start where there is room."
            : `${starts.length} start ${starts.length === 1 ? "place is" : "places are"} set on the map.`}
        </span>
        {starts.length > 0 && (
          <Button tone="quiet" onPress={() => live.store.setState({ starts: [] })}>
            Forget them
          </Button>
        )}
      </div>
      <Button icon="map" onPress={() => void live.trials.tryOut(false)}>
        Show on the map, without running
      </Button>
    </div>
  );
}

function Count({ value, isDisabled, set }: { value: number; isDisabled: boolean; set: (value: number) => void }) {
  const [typed, setTyped] = useState(String(value));
  const count = Number(typed);
  const isGood = Number.isInteger(count) && count >= 1 && count <= kMostRobots;
  return (
    <Field
      label="Robots"
      value={typed}
      committed={String(value)}
      onChange={setTyped}
      inputMode="numeric"
      isDisabled={isDisabled}
      problem={isGood ? undefined : `From 1 to ${kMostRobots}.`}
      {...(isDisabled ? { help: "The society says how many" } : {})}
      onCommit={() => isGood && count !== value && set(count)}
    />
  );
}
