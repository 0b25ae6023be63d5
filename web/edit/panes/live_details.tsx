// At the end of the details of what is selected, while it runs: its value, its breakpoints.
import { useState } from "react";
import { atCondition, kComparisons } from "../../console/breakpoints/break_points.ts";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import { Section } from "../../designer/details/parts.tsx";
import { LiveArrow } from "../../designer/running/badge.tsx";
import { useLive } from "../../designer/running/use_live.ts";
import type { Drawing } from "../../designer/session/protocol.ts";
import { useDesigner, usePart } from "../../designer/session/use.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, Field, IconButton } from "../../ui/controls/controls.tsx";
import { joined } from "../run/places.ts";
import { type Target, targetOf } from "../run/targets.ts";
import { HoldValue } from "./hold_value.tsx";
import { InSession } from "./in_session.tsx";
import { breaksOnValue, liveMenu } from "./menu.ts";
import { useActiveState, useLivePage, usePath } from "./use_live_part.ts";

export function LiveDetails({ drawing, id }: { drawing: Drawing; id: string }) {
  const target = targetOf(drawing, id);
  if (!target) return null;
  return (
    <InSession>
      <RunningDetails drawing={drawing} id={id} target={target} />
    </InSession>
  );
}

function RunningDetails({ drawing, id, target }: { drawing: Drawing; id: string; target: Target }) {
  const designer = useDesigner();
  const path = usePath(target.kind === "value" ? target.live : ".");
  usePart((state) => state.marks);
  useSessionPart("roster");
  useSessionPart("selection");
  useActiveState();
  // What holds a value has a field of its own.
  const actions = liveMenu(designer, id).filter((one) => one.blocked === undefined && one.id !== "hold");
  const isRunning = path !== "";
  if (!isRunning && actions.length === 0) return null;
  return (
    <Section title="While it runs">
      <div className="rows live-details">
        {target.kind === "value" && isRunning && <Value drawing={drawing} live={target.live} />}
        <div className="columns" style={{ gap: 4 }}>
          {actions.map((one) => (
            <Button key={one.id} {...(one.icon ? { icon: one.icon } : {})} onPress={one.run}>
              {one.label}
            </Button>
          ))}
        </div>
        {target.kind === "value" && <BreakWhen drawing={drawing} target={target} id={id} />}
        {target.kind === "value" && isRunning && <HoldValue key={path} path={path} />}
      </div>
    </Section>
  );
}

function Value({ drawing, live }: { drawing: Drawing; live: string }) {
  const value = useLive(drawing.page?.path ?? "", live);
  if (!value) return null;
  return (
    <p className="live-value number">
      {value.vector && <LiveArrow {...value.vector} />}
      {value.text}
    </p>
  );
}

/** A breakpoint on a value: `is true`, `> 2`. */
function BreakWhen({ drawing, target, id }: { drawing: Drawing; target: Target & { kind: "value" }; id: string }) {
  const live = useLivePage();
  const { live: below, type } = target;
  const count = breaksOnValue(live, drawing, id);
  const [comparison, setComparison] = useState<Comparison>(type === "bool" ? Comparison.EQUAL : Comparison.GREATER);
  const [typed, setTyped] = useState("");
  const set = () => {
    if (typed.trim() === "") return;
    void live.marks.setBreakpoint((place) => atCondition(joined(place, below), comparison, typed.trim()), id);
    setTyped("");
  };
  if (type === "bool") return null;
  return (
    <div className="break-when">
      <Choice
        label="Pause when it is"
        value={String(comparison)}
        choices={kComparisons.map(([one, sign]) => [String(one), sign] as const)}
        onChange={(next) => setComparison(Number(next) as Comparison)}
      />
      <Field
        label="Value"
        value={typed}
        committed=""
        onChange={setTyped}
        placeholder={type === "Vector" ? "its length" : ""}
      />
      <IconButton icon="plus" label="Set the breakpoint" isDisabled={typed.trim() === ""} onPress={set} />
      {count > 0 && <span className="small muted">{count} set</span>}
    </div>
  );
}
