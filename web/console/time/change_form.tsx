// What is to be otherwise: a parameter, an order, or the text of a configuration, a mission or an overlay.
import { useEffect, useId } from "react";
import { Field, Segments, Switch } from "../../ui/controls/controls.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { usePart } from "../session/session.ts";
import { useFuture, useFuturePart } from "./future_panel.tsx";
import type { ChangeKind } from "./future_store.ts";

/** Nothing is chosen yet. */
const kNone = ["", "–"] as const;

const kSettled = 200; // ms: somebody who scrubs has come to rest

const kKinds: readonly (readonly [ChangeKind, string])[] = [
  ["parameter", "Parameter"],
  ["order", "Order"],
  ["text", "Design"],
  ["nothing", "Nothing"],
];

export function ChangeForm({ cycle, isComing }: { cycle: number; isComing: boolean }) {
  const store = useFuture();
  const kind = useFuturePart("kind");
  const target = useFuturePart("target");
  const seconds = useFuturePart("seconds");
  const withoutPeople = useFuturePart("withoutPeople");
  const isWanted = !isComing && (kind === "parameter" || kind === "text");
  useEffect(() => {
    if (!isWanted) return;
    const timer = setTimeout(() => void store.readChangeable(cycle), kSettled);
    return () => clearTimeout(timer);
  }, [store, cycle, target, isWanted]);
  return (
    <>
      <Segments
        label="What is changed"
        value={kind}
        choices={kKinds}
        onChange={(next) => {
          store.set("kind", next);
          store.set("problem", "");
        }}
      />
      {kind === "parameter" && <ParameterFields />}
      {kind === "order" && <OrderField />}
      {kind === "text" && <TextFields />}
      {kind === "nothing" && <p className="small muted">It is then the run itself, as far as the run has gone.</p>}
      <Field
        label="For how long [s]"
        value={seconds}
        placeholder="to the end of the run, at least 60"
        inputMode="decimal"
        onChange={(text) => store.set("seconds", text)}
      />
      <Switch
        label="Without what people did afterwards"
        value={withoutPeople}
        onChange={(value) => store.set("withoutPeople", value)}
      />
    </>
  );
}

function ParameterFields() {
  const store = useFuture();
  const roster = usePart("roster");
  const changeable = useFuturePart("changeable");
  const port = useFuturePart("port");
  const value = useFuturePart("value");
  useFuturePart("target");
  usePart("selection");
  const robots = store.robots();
  const target = store.get("target") || String(robots[0] ?? "");
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
        <SelectEntry label="Whose" value={target} choices={targets} onChange={(next) => store.set("target", next)} />
        <SelectEntry
          label="Parameter"
          value={port}
          choices={[kNone, ...parameters.map((one) => [one.port!.path, one.port!.path] as const)]}
          isDisabled={parameters.length === 0}
          onChange={(next) => {
            store.set("port", next);
            store.set("value", parameters.find((one) => one.port?.path === next)?.value ?? "");
          }}
        />
      </div>
      {changeable?.whyNoParameters && <p className="small muted">{changeable.whyNoParameters}</p>}
      <Field
        label={unit === "" ? "Value" : `Value [${unit}]`}
        value={value}
        help={chosen ? `At that moment ${chosen.value}${unit === "" ? "" : ` ${unit}`}` : ""}
        isDisabled={!chosen}
        onChange={(text) => store.set("value", text)}
      />
    </>
  );
}

function OrderField() {
  const store = useFuture();
  const order = useFuturePart("order");
  const unit = usePart("roster").units[0]?.name ?? "scouts";
  return (
    <Field
      label="Order, as it is typed"
      value={order}
      placeholder={`UNIT ${unit} STOP`}
      onChange={(text) => store.set("order", text)}
    />
  );
}

function TextFields() {
  const store = useFuture();
  const changeable = useFuturePart("changeable");
  const path = useFuturePart("path");
  const text = useFuturePart("text");
  const id = useId();
  const texts = changeable?.texts ?? [];
  return (
    <>
      <SelectEntry
        label="Text of the configuration, mission or overlay"
        value={path}
        choices={[kNone, ...texts.map((one) => [one.path, one.path.split("/").at(-1) ?? one.path] as const)]}
        isDisabled={texts.length === 0}
        onChange={(next) => {
          store.set("path", next);
          store.set("text", texts.find((one) => one.path === next)?.text ?? "");
        }}
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
          onChange={(event) => store.set("text", event.target.value)}
        />
      </div>
    </>
  );
}
