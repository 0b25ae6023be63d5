// The selected control measure by name and numbers.
import { useEffect, useRef, useState } from "react";
import { useStore } from "zustand";
import { kindInfo } from "../../core/measure_kinds.ts";
import type { Measure } from "../../core/protocol.ts";
import { Button, Field, Switch } from "../../ui/controls/controls.tsx";
import { NumberEntry } from "../../ui/controls/number_entry.tsx";
import { editMap, removeItems } from "../map_editing/edit_map.ts";
import { useMayOrder, usePart, useSession } from "../session/session.ts";
import { drawingStore } from "./drawing_store.ts";
import { KindIcon } from "./kind_icon.tsx";
import { nameProblem } from "./names.ts";
import { odlText, parsePoints, pointLines } from "./odl_text.ts";
import {
  type EditedMeasure,
  editedMeasure,
  geometryOf,
  replaceMeasure,
  titleOf,
  withGeometry,
} from "./scene_measures.ts";

export function MeasureForm({ index, wire }: { index: number; wire: Measure }) {
  const measure = editedMeasure(wire);
  if (!measure) return <p className="notice">A control measure of a kind that this console does not know.</p>;
  return <Form index={index} measure={measure} document={wire.document} line={wire.line} />;
}

interface FormProps {
  index: number;
  measure: EditedMeasure;
  document: string;
  line: number;
}

function Form({ index, measure, document, line }: FormProps) {
  const session = useSession();
  const isLocked = !useMayOrder() || document === "";
  const info = kindInfo(measure.kind);
  const replace = (name: string, changed: EditedMeasure) =>
    void editMap(session, name, [replaceMeasure(index, changed)]);
  const title = titleOf(measure);
  return (
    <section aria-label={`${info.label} ${measure.name}`} className="overlay-chosen">
      <h3 className="columns">
        <KindIcon kind={measure.kind} />
        {info.label}
      </h3>
      <p className="help">{info.purpose}.</p>
      {document === "" && <p className="notice">It stands in the mission’s text, not in an overlay.</p>}
      <NameEntry
        index={index}
        measure={measure}
        isLocked={isLocked}
        onName={(name) => replace(`rename ${title}`, { ...measure, name })}
      />
      <div className="world-fields">
        {info.sizeLabel !== "" && (
          <NumberEntry
            label={`${info.sizeLabel[0]?.toUpperCase()}${info.sizeLabel.slice(1)} [m]`}
            value={measure.size}
            min={0}
            whenZero={String(info.defaultSize)}
            isDisabled={isLocked}
            onCommit={(size) => replace(`resize ${title}`, withGeometry(measure, { ...geometryOf(measure), size }))}
          />
        )}
        <div className="overlay-label">
          <Switch
            label="Show label"
            value={measure.showsLabel}
            isDisabled={isLocked}
            onChange={(showsLabel) =>
              replace(`${showsLabel ? "show" : "hide"} the label of ${title}`, { ...measure, showsLabel })
            }
          />
        </div>
      </div>
      <PointsEntry
        measure={measure}
        isLocked={isLocked}
        onPoints={(points) => replace(`move ${title}`, withGeometry(measure, { ...geometryOf(measure), points }))}
      />
      {measure.kind === "boundary" && (
        <p className="help">
          A name with WeatherZone, NoFlyZone or NoCommZone in it makes the boundary a zone
          {measure.zone === "" ? "." : `: this one is closed (${measure.zone}).`}
        </p>
      )}
      <code className="overlay-text">{odlText(measure)}</code>
      <div className="columns">
        <Button
          className="danger-quiet"
          isDisabled={isLocked}
          onPress={() => void removeItems(session, [{ kind: "measure", index }])}
        >
          Remove
        </Button>
        {document !== "" && (
          <Button tone="quiet" onPress={() => session.ui.set("reveal", { document, line })}>
            Show in the text
          </Button>
        )}
      </div>
    </section>
  );
}

function NameEntry(props: {
  index: number;
  measure: EditedMeasure;
  isLocked: boolean;
  onName: (name: string) => void;
}) {
  const { index, measure, isLocked, onName } = props;
  const measures = usePart("scene")?.measures ?? [];
  const { naming } = useStore(drawingStore);
  const [name, setName] = useState(measure.name);
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => setName(measure.name), [measure.name]);
  useEffect(() => {
    if (naming !== index) return;
    drawingStore.setState({ naming: -1 });
    const input = place.current?.querySelector("input");
    input?.focus();
    input?.select();
  }, [naming, index]);
  const others = measures.flatMap((m, i) => (i === index ? [] : [m.name]));
  const { error, warning } = nameProblem(name, others);
  const commit = () => {
    if (error === "" && name !== measure.name) onName(name);
  };
  return (
    <div ref={place}>
      <Field
        label="Name"
        value={name}
        onChange={setName}
        onCommit={commit}
        problem={error || undefined}
        {...(warning === "" ? {} : { help: warning })}
        isDisabled={isLocked}
      />
    </div>
  );
}

function PointsEntry(props: {
  measure: EditedMeasure;
  isLocked: boolean;
  onPoints: (points: { x: number; y: number }[]) => void;
}) {
  const { measure, isLocked, onPoints } = props;
  const info = kindInfo(measure.kind);
  const shown = pointLines(geometryOf(measure).points);
  const [text, setText] = useState(shown);
  useEffect(() => setText(shown), [shown]);
  const read = parsePoints(text);
  const problem = "error" in read ? read.error : countProblem(read.points.length, info.minPoints, info.maxPoints);
  const commit = () => {
    if (problem === "" && "points" in read && text !== shown) onPoints(read.points);
  };
  const rows = Math.min(8, Math.max(1, text.split("\n").length));
  return (
    <label className="field">
      <span className="label">{measure.kind === "hallway" ? "Centre line, x y [m]" : "Points, x y [m]"}</span>
      <textarea
        className="input overlay-points"
        rows={rows}
        value={text}
        disabled={isLocked}
        spellCheck={false}
        aria-invalid={problem !== ""}
        onChange={(event) => setText(event.target.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) commit();
          if (event.key === "Escape") setText(shown);
        }}
      />
      {problem !== "" && (
        <span className="problem" role="alert">
          {problem}
        </span>
      )}
    </label>
  );
}

function countProblem(count: number, least: number, most: number): string {
  if (count < least) return least === 1 ? "It needs a point." : `It needs at least ${least} points.`;
  if (count > most) return most === 1 ? "It has one point only." : `It has at most ${most} points.`;
  return "";
}
