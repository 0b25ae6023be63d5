import { useEffect, useMemo, useRef, useState } from "react";
import { Button as AriaButton, ListBox, ListBoxItem, Popover, Select, SelectValue } from "react-aria-components";
import type { Port } from "../../core/protocol.ts";
import { kSliderEnd, kSliderStep, placeOnSlider, valueOnSlider } from "../../core/slider_scale.ts";
import { Field, IconButton, RangeSlider, Search, Switch } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { count } from "../../ui/words/format.ts";
import { order } from "../session/orders.ts";
import { usePart, useSession, useWhyNoOrder } from "../session/session.ts";
import { isSwitchedOn, parameterKind, parameterProblem, sliderOf, valueNumber } from "./parameter.ts";
import { portGroups, spacedName } from "./ports.ts";
import { usePortText } from "./ports_tab.tsx";
import { usePorts } from "./use_watched.ts";

const kLive = 150; // ms between values while a slider is dragged

/** The parameters of the first robot's program; a change goes to all selected robots that have it. */
export function ParametersTab({ robots }: { robots: readonly number[] }) {
  const roster = usePart("roster");
  const why = useWhyNoOrder("change parameters");
  const [query, setQuery] = useState("");
  usePorts("parameters", true);
  const first = robots[0] as number;
  const ports = roster.portsOf(first);
  const program = roster.robot(first)?.program;
  const same = robots.filter((id) => roster.robot(id)?.program === program);
  const groups = useMemo(() => portGroups(ports, query, "parameters"), [ports, query]);
  return (
    <div className="rows tab-body">
      <Search label="Find a parameter" value={query} onChange={setQuery} />
      {robots.length > 1 && (
        <p className="notice">
          Changes go to {count(same.length, "robot")}
          {same.length < robots.length ? `; ${robots.length - same.length} with another program are left out` : ""}.
          Values are those of {roster.nameOf(first)}.
        </p>
      )}
      {why && <p className="notice">{why}</p>}
      {groups.map((group) => (
        <section key={group.node} className="rows" aria-label={group.node || "Program"}>
          <h3 className="mono port-node">{group.node || "program"}</h3>
          {group.rows.map((row) => (
            <Parameter
              key={row.index}
              port={row.port}
              index={row.index}
              name={spacedName(row.name)}
              robots={same}
              isDisabled={why !== undefined}
            />
          ))}
        </section>
      ))}
      {groups.length === 0 && (
        <p className="empty small">
          {ports.length === 0 ? "This robot has no program." : "No parameter is called that."}
        </p>
      )}
    </div>
  );
}

interface ParameterProps {
  port: Port;
  index: number;
  name: string;
  robots: readonly number[];
  isDisabled: boolean;
}

/** One parameter of these robots, with its control; also in the designer. */
export function Parameter({ port, index, name, robots, isDisabled }: ParameterProps) {
  const session = useSession();
  const shown = usePortText(robots[0] as number, index);
  const set = (value: string) =>
    void order(session, { case: "setParameter", value: { robots: [...robots], port: port.path, value } });
  const label = port.unit ? `${name} [${port.unit}]` : name;
  const control = { port, label, shown, isDisabled, set };
  const kind = parameterKind(port);
  return (
    <div className="parameter" title={port.help}>
      {kind === "slider" && <Slide {...control} />}
      {kind === "switch" && (
        <Switch
          label={label}
          value={isSwitchedOn(shown)}
          isDisabled={isDisabled}
          onChange={(on) => set(on ? "true" : "false")}
        />
      )}
      {kind === "choice" && <Choice {...control} />}
      {(kind === "number" || kind === "text") && <Write {...control} />}
      {port.initial !== "" && (
        <IconButton
          icon="restart"
          label={`Back to ${port.initial}`}
          isDisabled={isDisabled || sameValue(port.initial, shown)}
          onPress={() => set(port.initial)}
        />
      )}
    </div>
  );
}

interface ControlProps {
  port: Port;
  label: string;
  shown: string;
  isDisabled: boolean;
  set: (value: string) => void;
}

function Slide(control: ControlProps) {
  const { port, label, shown, isDisabled, set } = control;
  const scale = useMemo(() => sliderOf(port), [port]);
  const [dragged, setDragged] = useState<number | null>(null);
  const lastSent = useRef(0);
  // The slider stays where it was let go until the robot tells its new value.
  const told = useRef(shown);
  useEffect(() => {
    if (told.current !== shown) setDragged(null);
    told.current = shown;
  }, [shown]);
  const place = dragged ?? placeOnSlider(scale, valueNumber(shown) || 0);
  const text = (at: number) => String(valueOnSlider(scale, at));
  return (
    <div className="slide">
      <Write {...control} shown={dragged === null ? shown : text(dragged)} isCompact />
      <RangeSlider
        label={label}
        hiddenLabel
        value={place}
        min={0}
        max={kSliderEnd}
        step={kSliderStep}
        spoken={dragged === null ? shown : text(dragged)}
        isDisabled={isDisabled}
        onChange={(next) => {
          setDragged(next);
          if (performance.now() - lastSent.current < kLive) return;
          lastSent.current = performance.now();
          set(text(next));
        }}
        onCommit={(next) => set(text(next))}
      />
    </div>
  );
}

function Write({ port, label, shown, isDisabled, set, isCompact = false }: ControlProps & { isCompact?: boolean }) {
  const number = valueNumber(shown);
  const now = port.isNumber && !Number.isNaN(number) ? String(number) : shown;
  const [typed, setTyped] = useState<string | null>(null);
  const problem = typed === null ? undefined : parameterProblem(port, typed);
  const limits = [port.min !== undefined ? `from ${port.min}` : "", port.max !== undefined ? `to ${port.max}` : ""]
    .filter(Boolean)
    .join(" ");
  return (
    <Field
      label={label}
      value={typed ?? now}
      committed={now}
      // The first value that comes would else be put before what is being typed.
      isDisabled={isDisabled || (port.isNumber && shown === "")}
      problem={problem}
      {...(limits && !isCompact ? { help: limits } : {})}
      inputMode={port.isNumber ? "decimal" : "text"}
      onChange={setTyped}
      onCommit={(value) => {
        if (typed !== null && problem === undefined && value !== now) set(value.trim());
        if (problem === undefined) setTyped(null);
      }}
    />
  );
}

function Choice({ port, label, shown, isDisabled, set }: ControlProps) {
  return (
    <Select
      className="field grow"
      aria-label={label}
      selectedKey={port.choices.includes(shown) ? shown : null}
      isDisabled={isDisabled}
      onSelectionChange={(key) => key !== null && set(String(key))}
    >
      <span className="label">{label}</span>
      <AriaButton className="button select-button">
        <SelectValue />
        <Icon name="down" />
      </AriaButton>
      <Popover className="popover">
        <ListBox className="menu" items={port.choices.map((id) => ({ id }))}>
          {({ id }) => (
            <ListBoxItem id={id} className="menu-item" textValue={id}>
              {id}
            </ListBoxItem>
          )}
        </ListBox>
      </Popover>
    </Select>
  );
}

function sameValue(a: string, b: string): boolean {
  const [x, y] = [valueNumber(a), valueNumber(b)];
  return Number.isNaN(x) || Number.isNaN(y) ? a.trim() === b.trim() : x === y;
}
