// What if: how the run would have gone on from the moment that is shown with something else, or another recording beside it.
import { useEffect, useMemo, useRef } from "react";
import { FutureLayer } from "../../core/map/future_layer.ts";
import { isShown } from "../../core/other_future.ts";
import type { OtherFuture } from "../../core/protocol.ts";
import { momentText } from "../../core/run_time.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { list, readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart, useSession, useStored, useUi } from "../session/session.ts";
import { ChangeForm } from "./change_form.tsx";
import { FutureResult } from "./future_result.tsx";
import { type FutureParts, type FutureStore, futureOf } from "./future_store.ts";
import { ToldApart } from "./told_apart.tsx";
import { useTravel, useWhereabouts } from "./use_travel.ts";
import "./futures.css";

export function useFuture(): FutureStore {
  return futureOf(useSession());
}

export function useFuturePart<Name extends keyof FutureParts>(name: Name): FutureParts[Name] {
  return useStored<FutureParts, Name>(useFuture(), name);
}

export function WhatIfButton() {
  const store = useFuture();
  const isOpen = useFuturePart("isOpen");
  const future = usePart("otherFuture");
  usePart("timeLine");
  const whyNot = useTravel().whyNot;
  const label = future?.isRecording ? "Beside it" : "What if…";
  return (
    <Hint text={whyNot ?? "How it would have gone on from here with something else"}>
      <Button
        tone="quiet"
        className="what-if-button"
        aria-expanded={isOpen}
        isDisabled={whyNot !== undefined}
        onPress={() => store.toggle()}
      >
        {label}
        {future && <span className="time-hidden" />}
      </Button>
    </Hint>
  );
}

/** Draws the other future on the map, at the moment that is shown. */
export function useGhosts(): void {
  const { model } = useSession();
  const map = useUi("map");
  const future = usePart("otherFuture");
  const layer = useMemo(() => new FutureLayer(), []);
  useEffect(() => {
    if (!map || !isShown(future)) return;
    return map.addLayer((pen) => layer.draw(pen, model, model.time));
  }, [map, future, layer, model]);
}

export function FuturePanel() {
  const store = useFuture();
  const isOpen = useFuturePart("isOpen");
  const isAgain = useFuturePart("isAgain");
  const future = usePart("otherFuture");
  // A recording that is compared with is what the page was opened for.
  const isCompared = future?.isRecording === true;
  useEffect(() => {
    if (isCompared) store.set("isOpen", true);
  }, [isCompared, store]);
  const isResult = future !== null && !isAgain;
  const panel = useRef<HTMLElement>(null);
  // What was pressed has gone with the form: the keyboard stays in the panel.
  useEffect(() => {
    if (isResult && document.activeElement === document.body) panel.current?.focus();
  }, [isResult]);
  if (!isOpen) return null;
  const title = isResult && future.isRecording ? `Beside ‘${future.name}’` : "What if…";
  return (
    <section
      ref={panel}
      tabIndex={-1}
      className="time-find future"
      aria-label={isResult && future.isRecording ? "Beside another recording" : "What if"}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || (event.target as Element).getAttribute("aria-expanded") === "true") return;
        event.stopPropagation();
        store.set("isOpen", false);
      }}
    >
      <header>
        <h3>{title}</h3>
        <IconButton icon="close" label="Close" shortcut="Esc" onPress={() => store.set("isOpen", false)} />
      </header>
      <div className="future-body">{isResult ? <Future future={future} /> : <Ask />}</div>
    </section>
  );
}

function Ask() {
  const store = useFuture();
  const at = useWhereabouts();
  const future = usePart("otherFuture");
  const isAsking = useFuturePart("isAsking");
  const problem = useFuturePart("problem");
  useFuturePart("changes");
  usePart("clients");
  const whyNot = store.whyNot;
  return (
    <>
      <p className="small muted">
        From {momentText(at.time)} on the run is computed once more, with something changed. The run itself stays as it
        is.
      </p>
      <ChangeForm cycle={at.cycle} isComing={at.isComing} />
      {(whyNot ?? problem) !== "" && (
        <p className="time-find-problem small" role="alert">
          {whyNot ?? problem}
        </p>
      )}
      <div className="future-line">
        <Button
          tone="primary"
          isDisabled={isAsking || at.isComing || whyNot !== undefined}
          onPress={() => void store.compute(at.cycle)}
        >
          {isAsking ? "Asked…" : "Compute"}
        </Button>
        {future && <Button onPress={() => store.set("isAgain", false)}>Back</Button>}
      </div>
    </>
  );
}

function Future({ future }: { future: OtherFuture }) {
  const store = useFuture();
  const problem = useFuturePart("problem");
  const own = future.isRecording;
  return (
    <>
      {future.changes.length > 0 && (
        <p className="future-changes">
          From {momentText(future.from)} with {list(future.changes.map(readableMessage))}
        </p>
      )}
      {future.changes.length === 0 && !own && <p>From {momentText(future.from)} with nothing changed</p>}
      {future.remarks.length > 0 && <Remarks remarks={future.remarks} />}
      {future.isUnderWay ? <Progress future={future} /> : null}
      {future.problem !== "" && (
        <p className="time-find-problem" role="alert">
          {sentence(future.problem)}
        </p>
      )}
      {isShown(future) && <FutureResult future={future} />}
      {future.problem !== "" && <ToldApart future={future} />}
      {problem !== "" && (
        <p className="time-find-problem small" role="alert">
          {problem}
        </p>
      )}
      <div className="future-line">
        {future.isUnderWay && !own && <Button onPress={() => void store.forget()}>Cancel</Button>}
        {!future.isUnderWay && (
          <Button onPress={() => store.set("isAgain", true)}>{own ? "What if…" : "Another one…"}</Button>
        )}
        {isShown(future) && !own && (
          <Button icon="save" onPress={() => void store.save()}>
            Save as recording
          </Button>
        )}
        {!future.isUnderWay && !own && <Button onPress={() => void store.forget()}>Remove</Button>}
      </div>
    </>
  );
}

function Remarks({ remarks }: { remarks: readonly string[] }) {
  return (
    <ul className="future-remarks small" aria-label="How they began otherwise">
      {remarks.slice(0, 8).map((one) => (
        <li key={one}>{sentence(one)}</li>
      ))}
      {remarks.length > 8 && <li>and {remarks.length - 8} more</li>}
    </ul>
  );
}

function Progress({ future }: { future: OtherFuture }) {
  return (
    <div className="future-progress">
      <span className="small muted" role="status">
        Computed to {momentText(future.computedTo)} of {momentText(future.until)}
      </span>
      <progress
        className="time-find-progress"
        max={Math.max(1, future.until)}
        value={future.computedTo}
        aria-label="Computed"
      />
    </div>
  );
}
