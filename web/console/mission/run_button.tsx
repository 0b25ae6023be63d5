// The button that always has the one next thing to do: small in the top bar, whatever panel is open, and large in the
// Mission panel until the mission starts.
import { Control_Action, Status_Mode } from "../../core/protocol.ts";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { control } from "../session/orders.ts";
import { isAlike, useIsRecording, useMayOrder, useMode, useReading, useSession, useUi } from "../session/session.ts";
import { type MainButton, mainButton, stepWords } from "./main_button.ts";
import { pressMainButton } from "./press.ts";
import { situationOf } from "./situation.ts";
import "./run_button.css";

export function RunButton() {
  const session = useSession();
  const button = useMainButton();
  return (
    <Hint text={button.hint ? `${button.label}. ${button.hint}` : button.label} shortcut={shownShortcut("x")}>
      <Button
        className={`run-button ${button.tone}`}
        icon={button.icon}
        isDisabled={button.does.kind === "nothing"}
        onPress={() => pressMainButton(session)}
        aria-keyshortcuts="X"
        aria-label={button.label}
        data-testid="main-button"
      >
        {button.short ?? button.label}
      </Button>
    </Hint>
  );
}

/** Step, beside it. */
export function StepButton() {
  const session = useSession();
  const words = useReading(["status"], (model) => stepWords(model.get("status")));
  const mode = useMode();
  const mayOrder = useMayOrder();
  return (
    <IconButton
      icon="step"
      label={`Step: ${words}`}
      shortcut={shownShortcut("n")}
      isDisabled={!mayOrder || mode === Status_Mode.NO_MISSION || mode === Status_Mode.STOPPED}
      onPress={() => control(session, Control_Action.SINGLE_STEP)}
    />
  );
}

/** Gone once the mission has started: the top bar's has its place then. */
export function StartButton() {
  const session = useSession();
  const button = useMainButton();
  const mode = useMode();
  const isRecording = useIsRecording();
  if (isRecording || (mode !== Status_Mode.READY && mode !== Status_Mode.NO_MISSION)) return null;
  return (
    <>
      <Button
        className={`large start-button ${button.tone}`}
        icon={button.icon}
        isDisabled={button.does.kind === "nothing"}
        onPress={() => pressMainButton(session)}
        aria-keyshortcuts="X"
        data-testid="start-button"
      >
        {button.label}
        <kbd>{shownShortcut("x")}</kbd>
      </Button>
      <p className="hint small muted">{button.hint || "\u00a0"}</p>
    </>
  );
}

function useMainButton(): MainButton {
  const isStarting = useUi("isStarting");
  return useReading(kOfMainButton, (model) => mainButton(situationOf(model, isStarting)), isAlike);
}

const kOfMainButton = [
  "status",
  "clients",
  "welcome",
  "link",
  "questions",
  "documents",
  "plan",
  "moment",
  "timeLine",
  "preflight",
] as const;
