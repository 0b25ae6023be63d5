// A value of the selected robot's program that is held: at what, and let go.
import { useState } from "react";
import { parameterProblem } from "../../console/selection/parameter.ts";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { spokenPath } from "../../core/port_words.ts";
import type { HeldValues_Held as Held, Port } from "../../core/protocol.ts";
import { formatOf } from "../../core/value_types.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, Field, IconButton } from "../../ui/controls/controls.tsx";
import { heldAt } from "../run/interventions.ts";
import { shownText } from "../run/shown_value.ts";
import { useLivePage } from "./use_live_part.ts";

/** `path`: of the port. */
export function HoldValue({ path }: { path: string }) {
  const roster = useSessionPart("roster");
  const robot = useSessionPart("selection").robots[0] ?? 0;
  const held = heldAt(useSessionPart("held"), robot, path);
  const port = roster.portsOf(robot).find((one) => one.path === path);
  if (!port?.canBeHeld) return null;
  return <Holder port={port} held={held} whose={roster.nameOf(robot)} robot={robot} />;
}

interface HolderProps {
  port: Port;
  held: Held | undefined;
  robot: number;
  whose: string;
}

function Holder({ port, held, robot, whose }: HolderProps) {
  const live = useLivePage();
  const [typed, setTyped] = useState("");
  const isList = port.type === "Vector" || port.type === "Point";
  const problem = typed.trim() === "" || isList ? undefined : parameterProblem(port, typed);
  const canHold = typed.trim() !== "" && problem === undefined;
  const hold = async () => {
    if (canHold && (await live.intervening.hold(port.path, typed.trim()))) setTyped("");
  };
  const unit = port.unit === "" ? port.type : `${port.type}, ${port.unit}`;
  const label = `Hold it for ${whose} at [${unit}]`;
  const others = held ? [held.port, ...held.also].filter((one) => one !== port.path) : [];
  const words = port.type === "bool" ? ["true", "false"] : port.choices;
  return (
    <div className="hold-value">
      {words.length > 0 ? (
        <Choice label={label} value={typed} choices={words.map((one) => [one, one] as const)} onChange={setTyped} />
      ) : (
        <Field
          label={label}
          value={typed}
          committed=""
          problem={problem}
          placeholder={formatOf(port.type)}
          inputMode={port.isNumber && !isList ? "decimal" : "text"}
          onChange={setTyped}
        />
      )}
      <Button icon="lock" isDisabled={!canHold} onPress={() => void hold()}>
        Hold
      </Button>
      {held && (
        <>
          <p className="held-at">
            Held at {shownText(held.value, port.unit)}
            {others.length > 0 && <span className="small"> with {others.map(spokenPath).join(", ")}</span>}
          </p>
          <Button icon="release" onPress={() => void live.intervening.release(robot, held.port)}>
            Release
          </Button>
        </>
      )}
    </div>
  );
}

/** All that is held, of all robots. */
export function HeldValues() {
  const live = useLivePage();
  const all = useSessionPart("held");
  const roster = useSessionPart("roster");
  if (all.length === 0) return null;
  return (
    <section aria-label="Held values">
      <header className="columns spread">
        <h3>Held values</h3>
        {all.length > 1 && (
          <Button tone="quiet" onPress={() => void live.intervening.release(0, "")}>
            Release all
          </Button>
        )}
      </header>
      <ul className="break-list held-list">
        {all.map((one) => {
          const port = roster.portsOf(one.robot).find(({ path }) => path === one.port);
          const name = spokenPath(one.port);
          return (
            <li key={`${one.robot} ${one.port}`}>
              <span className="ellipsis grow" title={name}>
                {name}
              </span>
              <span className="held-at number">{shownText(one.value, port?.unit ?? "")}</span>
              <span className="small muted">{roster.nameOf(one.robot)}</span>
              <IconButton
                icon="release"
                label={`Release ${name} of ${roster.nameOf(one.robot)}`}
                onPress={() => void live.intervening.release(one.robot, one.port)}
              />
            </li>
          );
        })}
      </ul>
    </section>
  );
}
