// The editor of one input's value, beside its row: a field, a slider where there is a range, the words that it may be.
import { useMemo, useState } from "react";
import { Dialog, Popover } from "react-aria-components";
import { kSliderEnd, kSliderStep, placeOnSlider, sliderScale, valueOnSlider } from "../../core/slider_scale.ts";
import { Button, Field, IconButton, RangeSlider } from "../../ui/controls/controls.tsx";
import type { IconName } from "../../ui/controls/icons.tsx";
import { useTyped } from "../../ui/controls/typed.ts";
import { portOf, rowLabel } from "../drawing/form.ts";
import { numberIn, sliderValue } from "../drawing/quantity.ts";
import { fieldLabel, limitWords } from "../drawing/value_words.ts";
import type { Node, Port } from "../session/protocol.ts";
import { useDesigner, useDrawing, useIsReadOnly } from "../session/use.ts";
import { canvasStore, useCanvas } from "../sight/canvas_store.ts";

export function ValueEditor() {
  const editing = useCanvas((state) => state.editing);
  const drawing = useDrawing();
  if (!editing) return null;
  const { port: name, index } = portOf(editing.row);
  const node = drawing?.nodes.find((one) => one.name === editing.node);
  const port = node?.inputs.find((one) => one.name === name && one.index === index);
  const row = document.querySelector(`[data-row="${CSS.escape(`${editing.node}/${editing.row}`)}"]`);
  if (!node || !port || !row) return null;
  return (
    <Editor
      key={`${editing.node}/${editing.row}/${editing.what}`}
      page={drawing?.page?.path ?? ""}
      node={node}
      port={port}
      what={editing.what}
      row={row}
    />
  );
}

interface EditorProps {
  page: string;
  node: Node;
  port: Port;
  what: "value" | "weight";
  row: Element;
}

function Editor({ page, node, port, what, row }: EditorProps) {
  const close = () => canvasStore.setState({ editing: null });
  const label = what === "weight" ? `Weight of ${rowLabel(port)}` : nameOf(port);
  return (
    <Popover
      className="popover value-editor"
      triggerRef={{ current: row }}
      isOpen
      onOpenChange={(open) => !open && close()}
      placement="bottom start"
      offset={2}
    >
      <Dialog aria-label={label} className="content">
        {/* The field keeps Escape to itself. */}
        <div onKeyDownCapture={(event) => event.key === "Escape" && close()}>
          <ValueField page={page} node={node} port={port} what={what} onDone={close} />
        </div>
      </Dialog>
    </Popover>
  );
}

/** What it is for, and below it what it may be. */
function helpOf(port: Port, what: "value" | "weight", isCompact: boolean): string {
  if (what === "weight") return "1 where nothing is said.";
  const help = port.help === "" || /[.!?]$/.test(port.help) ? port.help : `${port.help}.`;
  const words = [isCompact ? "" : help, limitWords(port)].filter((part) => part !== "").join(" ");
  return words === "" ? "" : words[0]!.toUpperCase() + words.slice(1);
}

interface ValueFieldProps {
  /** Where the node is. */
  page: string;
  node: Node;
  port: Port;
  what: "value" | "weight";
  onDone: () => void;
  /** In the details: more of them stand below each other, and none takes the focus. */
  isCompact?: boolean;
  /** Whether it may become a parameter. */
  canExpose?: boolean;
}

/** Also in the details, where it stays. */
export function ValueField({ page, node, port, what, onDone, isCompact = false, canExpose = true }: ValueFieldProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const given = what === "weight" ? port.weight : port.value;
  const shown = given || (what === "value" ? port.initial : "");
  const { typed, type, show } = useTyped(shown);
  const [problem, setProblem] = useState<string | undefined>();
  const label = what === "weight" ? `Weight of ${rowLabel(port)}` : nameOf(port);
  const send = async (value: string) => {
    if (value === given || value === shown || isReadOnly) return onDone(); // a default that is only left is not written
    const answer = await designer.link.ask({
      case: "edit",
      value: {
        document: designer.state.document,
        revision: designer.drawing?.revision ?? 0n,
        name: value === "" ? `default of ${label}` : `set ${label} of ${node.name}`,
        changes: [{ change: setValue(page, node.name, port, what, value) }],
      },
    });
    if (answer.ok) onDone();
    else setProblem(answer.error);
  };
  const { min, max } = port;
  const number = numberIn(typed, port.unit);
  const hasRange =
    what === "value" && min !== undefined && max !== undefined && Number.isFinite(max - min) && number !== undefined;
  const choices = what === "value" ? port.choices : [];
  return (
    <div className="rows" style={{ gap: 8 }}>
      <Field
        label={what === "weight" ? label : fieldLabel(label, port.type, port.unit)}
        value={typed}
        committed={shown}
        onChange={(next) => {
          type(next);
          setProblem(undefined);
        }}
        onCommit={(next) => {
          show(next);
          void send(next.trim());
        }}
        problem={problem}
        autoFocus={!isCompact}
        isDisabled={isReadOnly}
        help={helpOf(port, what, isCompact)}
      />
      {hasRange && (
        <ValueSlider
          label={`${label}, slider`}
          port={port}
          number={number}
          typed={typed}
          isDisabled={isReadOnly}
          onChange={show}
          onCommit={(next) => void send(next)}
        />
      )}
      {choices.length > 0 && <ValueChoices choices={choices} typed={typed} onChoose={(next) => void send(next)} />}
      {what === "value" && !isReadOnly && (
        <ValueTools
          page={page}
          node={node}
          port={port}
          isCompact={isCompact}
          canExpose={canExpose}
          onDefault={() => void send("")}
          onDone={onDone}
        />
      )}
    </div>
  );
}

interface ValueChoicesProps {
  choices: readonly string[];
  typed: string;
  onChoose: (choice: string) => void;
}

function ValueChoices({ choices, typed, onChoose }: ValueChoicesProps) {
  const isReadOnly = useIsReadOnly();
  return (
    <div className="columns" style={{ gap: 4 }}>
      {choices.slice(0, 24).map((choice) => (
        <Button
          key={choice}
          tone={choice === typed ? "primary" : "plain"}
          isDisabled={isReadOnly}
          onPress={() => onChoose(choice)}
        >
          {choice}
        </Button>
      ))}
    </div>
  );
}

interface ValueToolsProps {
  page: string;
  node: Node;
  port: Port;
  isCompact: boolean;
  canExpose: boolean;
  onDefault: () => void;
  onDone: () => void;
}

function ValueTools({ page, node, port, isCompact, canExpose, onDefault, onDone }: ValueToolsProps) {
  const designer = useDesigner();
  const expose = () => {
    const value = { page, node: node.name, port: port.name, ...indexOf(port) };
    void designer.edit(`make ${nameOf(port)} a parameter`, { case: "expose", value });
    onDone();
  };
  return (
    <div className={isCompact ? "value-tools" : "columns"} style={{ gap: 4 }}>
      {port.initial !== "" && port.value !== "" && (
        <Tool icon="restart" label={`Default: ${port.initial}`} isCompact={isCompact} onPress={onDefault} />
      )}
      {canExpose && !port.isExposed && port.type !== "" && (
        <Tool icon="gear" label="Make it a parameter" isCompact={isCompact} onPress={expose} />
      )}
    </div>
  );
}

function nameOf(port: Port): string {
  return port.label || port.name;
}

interface ValueSliderProps {
  label: string;
  port: Port;
  number: number;
  typed: string;
  isDisabled: boolean;
  onChange: (typed: string) => void;
  onCommit: (typed: string) => void;
}

/** Goes by ratios where the range spans decades; the field beside it takes any number. */
function ValueSlider({ label, port, number, typed, isDisabled, onChange, onCommit }: ValueSliderProps) {
  const { min = 0, max = 1, type, unit, initial } = port;
  const scale = useMemo(
    () => sliderScale({ min, max, usual: numberIn(initial, unit) ?? Number.NaN, isWhole: /^(int|count)/.test(type) }),
    [min, max, type, unit, initial],
  );
  const text = (place: number) => sliderValue(valueOnSlider(scale, place), typed, unit);
  return (
    <RangeSlider
      label={label}
      hiddenLabel
      spoken={typed}
      value={placeOnSlider(scale, number)}
      min={0}
      max={kSliderEnd}
      step={kSliderStep}
      isDisabled={isDisabled}
      onChange={(place) => onChange(text(place))}
      onCommit={(place) => onCommit(text(place))}
    />
  );
}

function Tool({
  icon,
  label,
  isCompact,
  onPress,
}: {
  icon: IconName;
  label: string;
  isCompact: boolean;
  onPress: () => void;
}) {
  if (isCompact) return <IconButton icon={icon} label={label} onPress={onPress} />;
  return (
    <Button tone="quiet" icon={icon} onPress={onPress}>
      {label}
    </Button>
  );
}

function indexOf(port: Port): { index?: number } {
  return port.index === undefined ? {} : { index: port.index };
}

function setValue(page: string, node: string, port: Port, what: "value" | "weight", value: string) {
  const name = what === "weight" ? "weight" : port.name;
  return { case: "setValue" as const, value: { page, node, port: name, value, ...indexOf(port) } };
}
