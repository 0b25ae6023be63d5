import { useState } from "react";
import { Status_Mode, type Status_RealTime } from "../../core/protocol.ts";
import { Button, RangeSlider } from "../../ui/controls/controls.tsx";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { PopoverButton } from "../../ui/controls/menus.tsx";
import { quantity, speedFactor } from "../../ui/words/format.ts";
import { setSpeed } from "../session/orders.ts";
import { usePart, useSession, useWhyNoOrder } from "../session/session.ts";
import { kPresets, kSliderEnd, sliderOf, speedOf } from "./speed.ts";

/** How fast simulated time passes: as set, and as reached. */
export function SpeedControl() {
  const status = usePart("status");
  if (!status) return null;
  const isRunning = status.mode === Status_Mode.RUNNING;
  if (status.realTime) return <Punctuality of={status.realTime} />;
  const isSlow = status.speed > 0 && status.speedReached > 0 && status.speedReached < status.speed * 0.9;
  return (
    <PopoverButton
      label="Speed"
      trigger={
        <Button tone="quiet" className="number">
          <Icon name="gauge" />
          <span className="hidden-text">Speed </span>
          {speedFactor(status.speed)}
          {isRunning && (status.speed === 0 || isSlow) && status.speedReached > 0 && (
            <span className="muted small">×{quantity(status.speedReached, 2)} reached</span>
          )}
          <Icon name="down" />
        </Button>
      }
    >
      <SpeedChoice />
    </PopoverButton>
  );
}

/** Of robots that nobody waits for: time passes as on the clock, whatever they do. */
function Punctuality({ of }: { of: Status_RealTime }) {
  const all = Number(of.robotCycles);
  const late = Number(of.late);
  const share = all > 0 ? (100 * late) / all : 0;
  return (
    <PopoverButton
      label="Real time"
      trigger={
        <Button tone="quiet" className="number">
          <Icon name="gauge" />
          Real time
          {late > 0 && <span className="muted small">{quantity(share, 2)} % late</span>}
          <Icon name="down" />
        </Button>
      }
    >
      <div className="rows" style={{ width: 330 }}>
        <p>The robots are on other machines and are not waited for, so time passes as on the clock.</p>
        <FactList
          rows={[
            ["Robot cycles", all],
            ["Too late", `${late} (${quantity(share, 2)} %)`],
            ["Robot stood for", `${Number(of.stood)} of these`],
            ["Oldest percepts", `${quantity(of.worstAge, 3)} s`],
          ]}
        />
      </div>
    </PopoverButton>
  );
}

function SpeedChoice() {
  const session = useSession();
  const status = usePart("status");
  const why = useWhyNoOrder("change it");
  const mayOrder = why === undefined;
  const speed = status?.speed ?? 1;
  const [dragged, setDragged] = useState<number | null>(null);
  const slider = dragged ?? sliderOf(speed);
  const set = (next: number) => {
    setDragged(null);
    setSpeed(session, next);
  };
  return (
    <div className="rows" style={{ width: 330 }}>
      <RangeSlider
        label="Simulated seconds per second"
        shown={speedFactor(speedOf(slider))}
        value={slider}
        min={0}
        max={kSliderEnd}
        step={1}
        isDisabled={!mayOrder}
        onChange={setDragged}
        onCommit={(value) => set(speedOf(value))}
      />
      <div className="columns">
        {kPresets.map((preset) => (
          <Button
            key={preset}
            className="preset"
            tone={preset === speed ? "primary" : "plain"}
            isDisabled={!mayOrder}
            onPress={() => set(preset)}
          >
            {preset === 0 ? "Max" : `×${preset}`}
          </Button>
        ))}
      </div>
      <p className="small muted">
        {status && status.speedReached > 0
          ? `Reached over the last second: ×${quantity(status.speedReached, 3)}.`
          : "Time stands still."}
        {status && status.behind > 1 ? ` The simulation is ${quantity(status.behind, 2)} s late.` : ""}
        {why ? ` ${why}` : ""}
      </p>
    </div>
  );
}
