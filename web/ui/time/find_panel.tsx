// Looks for moments at which something becomes true, and lists them.
import { type RefObject, useEffect, useRef, useState } from "react";
import type { Finding } from "../../core/moment_finder.ts";
import { momentText } from "../../core/run_time.ts";
import { Button, IconButton } from "../controls/controls.tsx";
import { count, readableMessage } from "../words/format.ts";
import { sentence } from "../words/sentence.ts";
import { ConditionField } from "./condition_field.tsx";

export interface FindProps {
  finding: Finding;
  /** Conditions with what they say. */
  examples: readonly (readonly [string, string])[];
  /** Of the run [s]. */
  end: number;
  /** That is shown [s]. */
  time: number;
  onFind: (condition: string) => void;
  onCancel: () => void;
  onGo: (time: number) => void;
  onNext: (by: 1 | -1) => void;
  onClose: () => void;
}

const kMostRows = 300;

export function FindPanel(props: FindProps) {
  const { finding, end, onFind, onCancel, onNext, onClose } = props;
  const [text, setText] = useState(finding.condition);
  const box = useRef<HTMLElement>(null);
  useFocusOnce(box);
  const { moments, isUnderWay, problem } = finding;
  const isTold = finding.condition !== "";
  return (
    <section
      ref={box}
      className="time-find"
      aria-label="Find moments"
      onKeyDown={(event) => {
        // The first one closes the examples.
        const isOpen = (event.target as Element).getAttribute("aria-expanded") === "true";
        if (event.key !== "Escape" || isOpen) return;
        event.stopPropagation();
        onClose();
      }}
    >
      <header>
        <h3>Find moments</h3>
        <IconButton icon="close" label="Close" shortcut="Esc" onPress={onClose} />
      </header>
      <div className="time-find-line">
        <ConditionField
          label="When was it so that"
          text={text}
          examples={props.examples}
          placement="top start"
          onText={setText}
          onEnter={onFind}
        />
        {isUnderWay ? (
          <Button onPress={onCancel}>Cancel</Button>
        ) : (
          <Button tone="primary" isDisabled={text.trim() === ""} onPress={() => onFind(text)}>
            Find
          </Button>
        )}
      </div>
      {problem !== "" && (
        <p className="time-find-problem small" role="alert">
          {sentence(readableMessage(problem))}
        </p>
      )}
      {isTold && problem === "" && (
        <div className="time-find-line">
          <span className="small muted grow" role="status">
            {found(finding, end)}
          </span>
          <IconButton icon="up" label="The one before" isDisabled={moments.length === 0} onPress={() => onNext(-1)} />
          <IconButton icon="down" label="The next one" isDisabled={moments.length === 0} onPress={() => onNext(1)} />
        </div>
      )}
      {isUnderWay && (
        <progress
          className="time-find-progress"
          max={Math.max(end, 1)}
          value={finding.searchedTo}
          aria-label="Searched"
        />
      )}
      {moments.length > 0 && <Rows {...props} />}
    </section>
  );
}

function found({ moments, isUnderWay, searchedTo, isCut }: Finding, end: number): string {
  const many = moments.length === 0 ? "Nothing" : count(moments.length, "moment");
  if (isUnderWay) return `${many} so far, searched to ${momentText(searchedTo)} of ${momentText(end)}`;
  if (isCut) return `${many} up to ${momentText(searchedTo)}; it was not searched further`;
  return moments.length === 0 ? "It was never so." : `${many} in the whole run`;
}

function Rows({ finding, time, onGo }: FindProps) {
  const { moments } = finding;
  const at = moments.findLastIndex((one) => one.time <= time + 1e-6);
  const isThere = at >= 0 && Math.abs(moments[at]!.time - time) < 1e-3;
  // Those round the moment that is shown, where there are many.
  const first = Math.max(0, Math.min(at - kMostRows / 2, moments.length - kMostRows));
  return (
    <ol className="time-found" aria-label="Moments that were found">
      {moments.slice(first, first + kMostRows).map((one, i) => (
        <li key={`${first + i}`}>
          <button
            type="button"
            className="time-found-row"
            aria-current={isThere && first + i === at ? "true" : undefined}
            onClick={() => onGo(one.time)}
          >
            <span className="number muted">{momentText(one.time)}</span>
            <span>{sentence(readableMessage(one.text))}</span>
          </button>
        </li>
      ))}
    </ol>
  );
}

function useFocusOnce(box: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    box.current?.querySelector("input")?.focus();
  }, [box]);
}
