// What makes the mission go on, wait or begin anew, and how fast.
import { Control_Action } from "../../core/protocol.ts";
import type { ActionRow } from "../../ui/commands/declared.ts";
import { type MainButton, mainButton } from "../mission/main_button.ts";
import { pressMainButton } from "../mission/press.ts";
import { situationOf } from "../mission/situation.ts";
import { neighbour } from "../mission/speed.ts";
import { answer, askFirst, control, emergencyStop, setSpeed } from "../session/orders.ts";
import type { ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { emergencyStopped, noMission, onlyWatching } from "./hindrances.ts";

export const kStopShortcut = "ctrl+.";

function mainButtonOf({ model }: Session): MainButton {
  return mainButton(situationOf(model));
}

function speedOf({ model }: Session): number {
  return model.get("status")?.speed ?? 1;
}

const kToStep = [onlyWatching, noMission, emergencyStopped];

export const kRunTable: ActionTable = {
  group: "Run",
  rows: [
    {
      id: "stop",
      label: "Emergency stop",
      icon: "stop",
      shortcut: kStopShortcut,
      everywhere: true,
      run: (session) => void emergencyStop(session),
    },
    {
      id: "main",
      label: (session) => mainButtonOf(session).label,
      icon: (session) => mainButtonOf(session).icon,
      shortcut: "x",
      unless: [
        (session) => {
          const { does, hint } = mainButtonOf(session);
          return does.kind === "nothing" ? hint : undefined;
        },
      ],
      run: (session) => pressMainButton(session),
    },
    {
      id: "step",
      label: "Single step of the mission, then stop",
      icon: "step",
      shortcut: "n",
      unless: kToStep,
      run: (session) => control(session, Control_Action.SINGLE_STEP),
    },
    {
      id: "skip",
      label: "Skip a step",
      icon: "skip",
      shortcut: "shift+n",
      unless: kToStep,
      run: (session) => control(session, Control_Action.SKIP_STEP),
    },
    {
      id: "cycle",
      label: "Single control cycle",
      icon: "cycle",
      shortcut: "c",
      unless: kToStep,
      run: (session) => control(session, Control_Action.SINGLE_CYCLE),
    },
    {
      id: "rewind",
      label: "Rewind to the first step",
      icon: "rewind",
      unless: kToStep,
      run: (session) => control(session, Control_Action.REWIND),
    },
    {
      id: "restart",
      label: "Restart the run",
      icon: "restart",
      unless: [onlyWatching, noMission],
      run: (session) => askFirst(session, Control_Action.RESTART),
    },
    {
      id: "abort",
      label: "Abort the mission",
      icon: "abort",
      unless: kToStep,
      run: (session) => askFirst(session, Control_Action.ABORT),
    },
    {
      id: "faster",
      label: "Faster",
      icon: "gauge",
      shortcut: ">",
      unless: [onlyWatching],
      run: (session) => setSpeed(session, neighbour(speedOf(session), 1)),
    },
    {
      id: "slower",
      label: "Slower",
      icon: "gauge",
      shortcut: "<",
      unless: [onlyWatching],
      run: (session) => setSpeed(session, neighbour(speedOf(session), -1)),
    },
    {
      id: "real-time",
      label: "Speed of real time",
      icon: "gauge",
      unless: [onlyWatching],
      run: (session) => setSpeed(session, 1),
    },
  ],
};

/** Answers are to the question that was the oldest when they were listed, and to none that came later. */
export function answerTable({ model }: Session): ActionTable {
  const oldest = model.get("questions")[0];
  const unless: ActionRow<Session>["unless"] = [onlyWatching, () => (oldest ? undefined : "Nothing is asked.")];
  return {
    group: "Run",
    rows: [
      {
        id: "proceed",
        label: "Answer the oldest question: proceed",
        icon: "check",
        shortcut: "p",
        unless,
        run: (session) => oldest && answer(session, oldest.id, true),
      },
      {
        id: "refuse",
        label: "Answer the oldest question: abort",
        icon: "abort",
        shortcut: "shift+p",
        unless,
        run: (session) => oldest && answer(session, oldest.id, false),
      },
    ],
  };
}
