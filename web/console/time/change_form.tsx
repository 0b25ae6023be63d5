// What is to be otherwise: parameters, orders, texts of a configuration, a mission or an overlay.
import { useEffect, useId, useState } from "react";
import { Button, Field, IconButton, Segments, Switch } from "../../ui/controls/controls.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { usePart } from "../session/session.ts";
import { useFuture, useFuturePart } from "./future_panel.tsx";
import { type Change, type ChangeKind, fileName, kMostChanges, readLength } from "./future_store.ts";

/** Nothing is chosen yet. */
const kNone = ["", "–"] as const;

const kSettled = 200; // ms: somebody who scrubs has come to rest

const kKinds: readonly (readonly [ChangeKind, string])[] = [
  ["parameter", "Parameter"],
  ["order", "Order"],
  ["text", "Design"],
];

export function ChangeForm({ cycle, isComing }: { cycle: number; isComing: boolean }) {
  const store = useFuture();
  const changes = useFuturePart("changes");
  const withoutPeople = useFuturePart("withoutPeople");
  usePart("selection");
  usePart("roster");
  const wanted = store.wanted().join();
  useEffect(() => {
    if (isComing || wanted === "") return;
    const timer = setTimeout(() => void store.readChangeable(cycle), kSettled);
    return () => clearTimeout(timer);
  }, [store, cycle, wanted, isComing]);
  return (
    <div className="future-halves">
      <div>
        {changes.map((change, i) => (
          <ChangeFields key={change.id} change={change} number={changes.length > 1 ? i + 1 : 0} />
        ))}
        {changes.length === 0 && (
          <p className="small muted">With nothing changed it is the run itself, as far as the run has gone.</p>
        )}
        <div className="future-line">
          <Button icon="plus" tone="quiet" isDisabled={changes.length >= kMostChanges} onPress={() => store.add()}>
            {changes.length === 0 ? "Change something" : "Change something else, too"}
          </Button>
        </div>
      </div>
      <div>
        <LengthField />
        <Switch
          label="Without what people did afterwards"
          value={withoutPeople}
          onChange={(value) => store.set("withoutPeople", value)}
        />
      </div>
    </div>
  );
}

function LengthField() {
  const store = useFuture();
  const length = useFuturePart("length");
  const [isEntered, setEntered] = useState(false);
  const read = readLength(length);
  return (
    <Field
      label="For how long"
      value={length}
      placeholder="1:30, or 90 s; else to the end of the run, at least 1:00"
      problem={isEntered && typeof read === "string" ? read : undefined}
      onChange={(text) => {
        setEntered(false);
        store.set("length", text);
      }}
      onCommit={() => setEntered(true)}
    />
  );
}

/** @param number from 1; 0: it is the only one */
function ChangeFields({ change, number }: { change: Change; number: number }) {
  const store = useFuture();
  usePart("clients");
  const { kind } = change;
  const name = number === 0 ? "What is changed" : `Change ${number}`;
  const whyNoText = store.whyNoText;
  return (
    <section className="future-change" aria-label={name}>
      <div className="future-line">
        <Segments
          label={name}
          value={kind}
          choices={kKinds}
          {...(whyNoText === undefined ? {} : { disabled: ["text"] })}
          onChange={(next) => store.alter(change.id, { kind: next })}
        />
        <IconButton
          icon="close"
          label={`Remove ${number === 0 ? "this change" : `change ${number}`}`}
          onPress={({ target }) => {
            const panel = target.closest<HTMLElement>(".future");
            store.remove(change.id);
            // What was pressed is gone: the keyboard stays in the panel.
            panel?.focus();
          }}
        />
      </div>
      {whyNoText !== undefined && <p className="small muted">{whyNoText}</p>}
      {kind === "parameter" && <ParameterFields change={change} />}
      {kind === "order" && <OrderField change={change} />}
      {kind === "text" && <TextFields change={change} />}
    </section>
  );
}

function ParameterFields({ change }: { change: Change }) {
  const store = useFuture();
  const roster = usePart("roster");
  useFuturePart("changeable");
  const { id, port, value } = change;
  const changeable = store.changeableOf(change);
  const target = change.target || String(store.robotsOf(change)[0] ?? "");
  const parameters = changeable?.parameters ?? [];
  const chosen = parameters.find((one) => one.port?.path === port);
  const unit = chosen?.port?.unit ?? "";
  const targets = [
    ...roster.robots.map(({ id }) => [String(id), roster.nameOf(id)] as const),
    ...roster.units.map(({ name }) => [name, `Unit ${name}`] as const),
  ];
  return (
    <>
      <div className="future-pair">
        <SelectEntry
          label="Whose"
          value={target}
          choices={targets}
          onChange={(next) => store.alter(id, { target: next })}
        />
        <SelectEntry
          label="Parameter"
          value={port}
          choices={[kNone, ...parameters.map((one) => [one.port!.path, one.port!.path] as const)]}
          isDisabled={parameters.length === 0}
          onChange={(next) =>
            store.alter(id, { port: next, value: parameters.find((one) => one.port?.path === next)?.value ?? "" })
          }
        />
      </div>
      {changeable?.whyNoParameters && <p className="small muted">{changeable.whyNoParameters}</p>}
      <Field
        label={unit === "" ? "Value" : `Value [${unit}]`}
        value={value}
        help={chosen ? `At that moment ${chosen.value}${unit === "" ? "" : ` ${unit}`}` : ""}
        isDisabled={!chosen}
        onChange={(text) => store.alter(id, { value: text })}
      />
    </>
  );
}

function OrderField({ change }: { change: Change }) {
  const store = useFuture();
  const unit = usePart("roster").units[0]?.name ?? "scouts";
  return (
    <Field
      label="Order, as it is typed"
      value={change.order}
      placeholder={`UNIT ${unit} STOP`}
      onChange={(text) => store.alter(change.id, { order: text })}
    />
  );
}

function TextFields({ change }: { change: Change }) {
  const store = useFuture();
  useFuturePart("changeable");
  const { path, text } = change;
  const id = useId();
  const texts = store.texts();
  return (
    <>
      <SelectEntry
        label="Text of the configuration, mission or overlay"
        value={path}
        choices={[kNone, ...texts.map((one) => [one.path, fileName(one.path)] as const)]}
        isDisabled={texts.length === 0}
        onChange={(next) =>
          store.alter(change.id, { path: next, text: texts.find((one) => one.path === next)?.text ?? "" })
        }
      />
      <div className="field">
        <label htmlFor={id}>As it is to be</label>
        <textarea
          id={id}
          className="input mono future-text"
          rows={8}
          spellCheck={false}
          value={text}
          disabled={path === ""}
          onChange={(event) => store.alter(change.id, { text: event.target.value })}
        />
      </div>
    </>
  );
}
