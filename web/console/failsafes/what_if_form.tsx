// Conditions that a person sets, and the code of the failsafes tried on them.
import { useEffect, useId, useRef, useState } from "react";
import { Failsafes_Row_Watch } from "../../core/protocol.ts";
import { Button, Field, Switch } from "../../ui/controls/controls.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { list } from "../../ui/words/format.ts";
import { readNumber } from "../../ui/words/read_number.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart } from "../session/session.ts";
import {
  type AtFence,
  askable,
  type Bounds,
  type Draft,
  fences,
  firstDraft,
  firstFence,
  firstSeconds,
  fitted,
  type Limits,
  labelOf,
  limitsOf,
  type OwnRow,
  orderOf,
  ownRows,
  wrongIn,
} from "./conditions.ts";
import { useStandings } from "./use_standings.ts";
import { type Trial, useTrial } from "./use_trial.ts";
import { WhatIfResult } from "./what_if_result.tsx";

export function WhatIf({ robot }: { robot: number }) {
  const rows = usePart("failsafes");
  const name = usePart("roster").nameOf(robot);
  const standings = usePart("standings").get(robot);
  useStandings("what-if", [robot]);
  const own = ownRows(rows, standings);
  const [draft, setDraft] = useState<Draft | null>(null);
  const limits = limitsOf(usePart("failsafeBounds"));
  const asked = fitted(draft ?? firstDraft(own, limits), own);
  const trial = useTrial(orderOf(robot, asked, limits));
  const tryIt = () => void trial.tryIt();
  const entry: EntryProps = { own, limits, asked, change: (next) => setDraft({ ...asked, ...next }), onEnter: tryIt };
  if (standings && own.length === 0)
    return (
      <section className="what-if" aria-label="What if?">
        <h3>What if?</h3>
        <p className="small muted">No row of the table is {name}'s: there is nothing to try.</p>
      </section>
    );
  return (
    <section className="what-if" aria-label="What if?">
      <h3>What if?</h3>
      <p className="small muted">
        Tried with {name}, which drives ahead on open ground, by the code that guards it. The run stays as it is.
      </p>
      {askable(own).map((condition) => (
        <LastingEntry key={condition} condition={condition} {...entry} />
      ))}
      <FenceEntry {...entry} />
      <TryIt {...entry} isUnderWay={trial.isUnderWay} />
      <Outcome trial={trial} />
    </section>
  );
}

/** The last number, and what has all of them tried. */
function TryIt({ asked, limits, change, onEnter, isUnderWay }: EntryProps & { isUnderWay: boolean }) {
  const reason = useId();
  const wrong = wrongIn(asked, limits);
  const isWrong = wrong.length > 0;
  return (
    <>
      <div className="what-if-last">
        <Amount
          label="Speed [m/s]"
          text={asked.speed}
          bounds={limits.speed}
          onChange={(speed) => change({ speed })}
          onEnter={onEnter}
        />
        <Button
          tone="primary"
          isDisabled={isWrong}
          isPending={isUnderWay}
          {...(isWrong ? { "aria-describedby": reason } : {})}
          onPress={onEnter}
        >
          Try it
        </Button>
      </div>
      {isWrong && (
        <p id={reason} className="small muted">
          To be put right first: {list(wrong)}.
        </p>
      )}
    </>
  );
}

/** Comes into sight by itself: it stands below everything else. */
function Outcome({ trial: { answer, isUnderWay } }: { trial: Trial }) {
  const rows = usePart("failsafes");
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (answer || isUnderWay) place.current?.scrollIntoView({ block: "nearest" });
  }, [answer, isUnderWay]);
  if (!answer && !isUnderWay) return null;
  return (
    <div ref={place} className="what-if-outcome">
      {isUnderWay && (
        <p className="small muted" role="status">
          It is being tried…
        </p>
      )}
      {answer && "error" in answer && (
        <p className="notice danger" role="alert">
          {sentence(answer.error)}
        </p>
      )}
      {answer && "trial" in answer && <WhatIfResult trial={answer.trial} rows={rows} />}
    </div>
  );
}

interface AmountProps {
  label: string;
  text: string;
  bounds: Bounds;
  onChange: (text: string) => void;
  onEnter: () => void;
}

/** A number that counts as it is typed: no answer stands beside another one. */
function Amount({ label, text, bounds: { min, max }, onChange, onEnter }: AmountProps) {
  const { problem } = readNumber(text, min, max);
  return (
    <Field label={label} value={text} onChange={onChange} onEnter={onEnter} problem={problem} inputMode="decimal" />
  );
}

interface EntryProps {
  own: readonly OwnRow[];
  limits: Limits;
  asked: Draft;
  change: (next: Partial<Draft>) => void;
  onEnter: () => void;
}

interface LastingProps extends EntryProps {
  condition: string;
}

function LastingEntry({ condition, own, limits, asked, change, onEnter }: LastingProps) {
  const isInRealTimeOnly = own.some(
    ({ row }) => row.condition === condition && row.watch === Failsafes_Row_Watch.REAL_TIME,
  );
  const isRealTime = usePart("status")?.realTime !== undefined;
  const value = asked.lasting[condition];
  const set = (seconds: string | undefined) => {
    const { [condition]: _, ...others } = asked.lasting;
    change({ lasting: seconds === undefined ? others : { ...others, [condition]: seconds } });
  };
  return (
    <div className="what-if-condition">
      <Switch
        label={labelOf(condition)}
        value={value !== undefined}
        onChange={(isOn) => set(isOn ? firstSeconds(own, condition, limits) : undefined)}
      />
      {value !== undefined && (
        <Amount label="for [s]" text={value} bounds={limits.seconds} onChange={set} onEnter={onEnter} />
      )}
      {value !== undefined && isInRealTimeOnly && !isRealTime && (
        <p className="small muted wide">
          Without <span className="unbroken">--real-time</span> nobody looks at it in this run.
        </p>
      )}
    </div>
  );
}

function FenceEntry({ own, limits, asked, change, onEnter }: EntryProps) {
  const choices = fences(own);
  const { fence } = asked;
  if (choices.length === 0) return null;
  return (
    <div className="what-if-condition">
      <Switch
        label="At a fence"
        value={fence !== null}
        onChange={(isOn) => change({ fence: isOn ? firstFence(own) : null })}
      />
      {fence && (
        <FencePlace
          fence={fence}
          choices={choices}
          limits={limits}
          set={(next) => change({ fence: { ...fence, ...next } })}
          onEnter={onEnter}
        />
      )}
    </div>
  );
}

interface FencePlaceProps {
  fence: AtFence<string>;
  choices: readonly (readonly [string, string])[];
  limits: Limits;
  set: (next: Partial<AtFence<string>>) => void;
  onEnter: () => void;
}

function FencePlace({ fence, choices, limits, set, onEnter }: FencePlaceProps) {
  return (
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
      <Amount
        label="Distance [m]"
        text={fence.distance}
        bounds={limits.distance}
        onChange={(distance) => set({ distance })}
        onEnter={onEnter}
      />
      <Amount
        label="Heading [deg]"
        text={fence.bearing}
        bounds={limits.bearing}
        onChange={(bearing) => set({ bearing })}
        onEnter={onEnter}
      />
      <p className="small muted wide">
        The distance is from the line. Heading 0 is straight out, 90 along the line, 180 straight in.
      </p>
      {fence.side === "outside" && (
        <div className="wide">
          <Switch label="Started there" value={fence.beginsThere} onChange={(beginsThere) => set({ beginsThere })} />
        </div>
      )}
    </div>
  );
}
