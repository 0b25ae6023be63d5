// The states of a robot's program over the whole run, also of when nobody looked.
import { useMemo, useState } from "react";
import { spokenPath } from "../../core/port_words.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { tracksOf } from "../../ui/time/sequences.ts";
import { StateStrips } from "../../ui/time/state_strip.tsx";
import { readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { useIsElsewhen, usePart } from "../session/session.ts";
import { useHasPast, usePast, useTravel, useWhereabouts } from "../time/use_travel.ts";

/** While the run goes on only who asks for it gets it: it is computed again for that. */
export function StatesOverTime({ robot }: { robot: number }) {
  const hasPast = useHasPast();
  const isElsewhen = useIsElsewhen();
  const [isWanted, setWanted] = useState(false);
  if (!hasPast) return null;
  const isShown = isElsewhen || isWanted;
  return (
    <section className="rows states-over-time" aria-label="States over the run">
      <div className="columns spread">
        <h3>States over the run</h3>
        {!isElsewhen && (
          <Button tone="link" aria-expanded={isShown} onPress={() => setWanted(!isWanted)}>
            {isShown ? "Hide" : "Show"}
          </Button>
        )}
      </div>
      {isShown && <Strips robot={robot} />}
    </section>
  );
}

function Strips({ robot }: { robot: number }) {
  const travel = useTravel();
  const { time } = useWhereabouts();
  const isDark = usePart("map").theme === "dark";
  const { past, problem } = usePast(useMemo(() => ({ statesOf: [robot] }), [robot]));
  const tracks = useMemo(() => {
    const states = past?.states.find((one) => one.robot === robot);
    return past ? tracksOf(states?.sequences ?? [], past.knownTo) : undefined;
  }, [past, robot]);
  if (problem !== "") return <p className="notice">{sentence(readableMessage(problem))}</p>;
  if (!tracks) return <p className="small muted">Being computed…</p>;
  return (
    <StateStrips
      tracks={tracks}
      end={travel.end}
      knownTo={past?.knownTo ?? 0}
      time={time}
      isDark={isDark}
      onGo={travel.does.go}
      nameOf={(path) => (path === "" ? "Program" : spokenPath(path))}
    />
  );
}
