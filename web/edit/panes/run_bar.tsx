// In the top bar: run, pause, one cycle, stop, how fast, what runs, and the same run in the console.

import { SpeedControl } from "../../console/mission/speed_control.tsx";
import { usePart as useSessionPart } from "../../console/session/session.ts";
import { Status_Mode } from "../../core/protocol.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { Icon, type IconName } from "../../ui/controls/icons.tsx";
import { PopoverButton } from "../../ui/controls/menus.tsx";
import { kRunKey, kStepKey, kStopKey } from "../run/keys.ts";
import { offersChange, offersTakeOver, type RunAct, runButton } from "../run/run_button.ts";
import { InSession } from "./in_session.tsx";
import { Setup } from "./setup.tsx";
import { useLivePage, useSituation } from "./use_live_part.ts";

const kIcons: Partial<Record<RunAct, IconName>> = { pause: "pause", release: "release", now: "right" };

export function RunBar() {
  return (
    <InSession>
      <Bar />
    </InSession>
  );
}

function Bar() {
  const live = useLivePage();
  const now = useSituation();
  const status = useSessionPart("status");
  const { act, label, hint } = runButton(now);
  const hasRun = status !== null && status.mode !== Status_Mode.NO_MISSION && status.mode !== Status_Mode.READY;
  return (
    <div className="run-bar" role="toolbar" aria-label="Running">
      <Hint text={hint} shortcut={shownShortcut(kRunKey)}>
        <Button
          tone={act === "pause" ? "plain" : "go"}
          data-tour="run"
          isDisabled={act === "none"}
          onPress={() => void live.trials.press()}
        >
          <Icon name={kIcons[act] ?? "play"} />
          {label}
        </Button>
      </Hint>
      {offersTakeOver(now) && (
        <Hint text="The robots go on with what the text says now, where they are; what can't be kept is told">
          <Button icon="right" onPress={() => void live.trials.takeOver()}>
            Take over
          </Button>
        </Hint>
      )}
      {offersChange(now) && (
        <Hint text="The text, or what is to run, has changed since it was run: begins anew with what stands there now">
          <Button icon="restart" onPress={() => void live.trials.tryOut(true)}>
            Run the change
          </Button>
        </Hint>
      )}
      <IconButton
        icon="step"
        label="One cycle"
        shortcut={shownShortcut(kStepKey)}
        isDisabled={!now.isConnected || now.isBusy || now.isElsewhen || !now.hasSubject}
        onPress={() => void live.trials.step()}
      />
      <IconButton
        icon="rewind"
        label="Stop: the robots go back to the start"
        shortcut={shownShortcut(kStopKey)}
        isDisabled={!hasRun || now.isElsewhen}
        onPress={() => void live.trials.stop()}
      />
      {status && status.mode !== Status_Mode.NO_MISSION && <SpeedControl />}
      <PopoverButton
        label="What runs"
        trigger={
          <Button tone="quiet" className="square" aria-label="What runs">
            <Icon name="gear" />
          </Button>
        }
      >
        <Setup />
      </PopoverButton>
      <IconButton icon="robots" label="Open in the console" onPress={() => live.operator.openConsole()} />
    </div>
  );
}
