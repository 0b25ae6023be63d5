// Conditions that a person sets, and the code of the failsafes tried on them.
import { useState } from "react";
import type { Failsafes_Row, FailsafeTrial } from "../../core/protocol.ts";
import { Button, Switch } from "../../ui/controls/controls.tsx";
import { NumberEntry } from "../../ui/controls/number_entry.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart, useSession } from "../session/session.ts";
import {
  type AtFence,
  askable,
  type Conditions,
  fences,
  firstConditions,
  firstFence,
  firstSeconds,
  kMost,
  type Lasting,
  orderOf,
} from "./what_if.ts";
import { WhatIfResult } from "./what_if_result.tsx";

type Answer = { trial: FailsafeTrial } | { error: string } | null;

export function WhatIf({ robot }: { robot: number }) {
  const { connection } = useSession();
  const rows = usePart("failsafes");
  const roster = usePart("roster");
  const [asked, setAsked] = useState(() => firstConditions(rows));
  const [answer, setAnswer] = useState<{ of: number; is: Answer }>({ of: robot, is: null });
  const change = (next: Partial<Conditions>) => {
    setAsked((before) => ({ ...before, ...next }));
    setAnswer({ of: robot, is: null });
  };
  const ask = async () => {
    const reply = await connection.ask({ case: "tryFailsafes", value: orderOf(robot, asked) });
    const found = reply.ok && reply.result.case === "failsafes" ? { trial: reply.result.value } : null;
    setAnswer({ of: robot, is: found ?? { error: reply.error || "The server did not answer." } });
  };
  const shown = answer.of === robot ? answer.is : null;
  return (
    <section className="what-if" aria-label="What if?">
      <h3>What if?</h3>
      <p className="small muted">
        Tried with {roster.nameOf(robot)}, which drives ahead on open ground, by the code that guards it. The run stays
        as it is.
      </p>
      {askable(rows).map(([condition, label]) => (
        <LastingEntry key={condition} condition={condition} label={label} rows={rows} asked={asked} change={change} />
      ))}
      <FenceEntry rows={rows} asked={asked} change={change} />
      <div className="what-if-last">
        <NumberEntry
          label="Speed [m/s]"
          value={asked.speed}
          min={0}
          max={kMost.speed}
          onCommit={(speed) => change({ speed })}
        />
        <Button tone="primary" onPress={() => void ask()}>
          Try it
        </Button>
      </div>
      {shown && "error" in shown && (
        <p className="notice danger" role="alert">
          {sentence(shown.error)}
        </p>
      )}
      {shown && "trial" in shown && <WhatIfResult trial={shown.trial} rows={rows} />}
    </section>
  );
}

interface EntryProps {
  rows: readonly Failsafes_Row[];
  asked: Conditions;
  change: (next: Partial<Conditions>) => void;
}

function LastingEntry({ condition, label, rows, asked, change }: EntryProps & { condition: Lasting; label: string }) {
  const value = asked.lasting[condition];
  const set = (seconds: number | undefined) => {
    const { [condition]: _, ...others } = asked.lasting;
    change({ lasting: seconds === undefined ? others : { ...others, [condition]: seconds } });
  };
  return (
    <div className="what-if-condition">
      <Switch
        label={label}
        value={value !== undefined}
        onChange={(isOn) => set(isOn ? firstSeconds(rows, condition) : undefined)}
      />
      {value !== undefined && (
        <NumberEntry label="for [s]" value={value} min={0} max={kMost.seconds} onCommit={(seconds) => set(seconds)} />
      )}
    </div>
  );
}

function FenceEntry({ rows, asked, change }: EntryProps) {
  const choices = fences(rows);
  const { fence } = asked;
  if (choices.length === 0) return null;
  const set = (next: Partial<AtFence>) => fence && change({ fence: { ...fence, ...next } });
  return (
    <div className="what-if-condition">
      <Switch
        label="At a fence"
        value={fence !== null}
        onChange={(isOn) => change({ fence: isOn ? firstFence(rows) : null })}
      />
      {fence && (
        <div className="what-if-fence">
          <SelectEntry
            label="Fence"
            value={String(fence.row)}
            choices={choices}
            onChange={(row) => set({ row: Number(row) })}
          />
          <SelectEntry
            label="Side"
            value={fence.side}
            choices={[
              ["inside", "Inside"],
              ["outside", "Outside"],
            ]}
            onChange={(side) => set({ side })}
          />
          <NumberEntry
            label="Distance [m]"
            value={fence.distance}
            min={0}
            max={kMost.distance}
            onCommit={(distance) => set({ distance })}
          />
          <NumberEntry
            label="Heading [deg]"
            value={fence.bearing}
            min={-kMost.bearing}
            max={kMost.bearing}
            onCommit={(bearing) => set({ bearing })}
          />
          <p className="small muted wide">
            The distance is from the line. Heading 0 is straight out, 90 along the line, 180 straight in.
          </p>
          {fence.side === "outside" && (
            <div className="wide">
              <Switch
                label="Started there"
                value={fence.beginsThere}
                onChange={(beginsThere) => set({ beginsThere })}
              />
            </div>
          )}
        </div>
      )}
    </div>
  );
}
