// Running among all that can be done: in the list of commands, and by keys.
import { kTimeTable } from "../../console/time/time_actions.ts";
import type { Action } from "../../designer/session/action.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { actionsOf } from "../../ui/commands/declared.ts";
import { kBreakKey, kFieldKey, kPinKey, kRunKey, kStepKey, kStopKey } from "../run/keys.ts";
import { knownLive, type Live, liveOf } from "../run/live.ts";
import { offersTakeOver, runButton } from "../run/run_button.ts";
import { showPane } from "../run/run_context.ts";
import { situationOf } from "../run/situation.ts";
import { liveMenu } from "./menu.ts";

/** Going through the run: its line stands below the drawing. */
function timeActions({ session }: Live): Action[] {
  return actionsOf(kTimeTable, session).map((one) => ({ ...one, group: "Time" }));
}

export function liveActions(designer: Designer): Action[] {
  const live = designer.document ? liveOf(designer) : knownLive(designer);
  if (!live || !designer.document) return [];
  const { act, label, hint } = runButton(situationOf(live));
  const none = act === "none" ? hint : undefined;
  const selected = designer.state.selection.length === 1 ? designer.state.selection[0]! : "";
  const menu = liveMenu(designer, selected);
  const { showsField } = live.store.getState();
  return [
    {
      id: "run",
      label,
      group: "Run",
      icon: "play",
      shortcut: kRunKey,
      blocked: none,
      run: () => void live.trials.press(),
    },
    {
      id: "step",
      label: "One cycle",
      group: "Run",
      icon: "step",
      shortcut: kStepKey,
      run: () => void live.trials.step(),
    },
    {
      id: "take-over",
      label: "Take over the change: the robots go on with it",
      group: "Run",
      blocked: offersTakeOver(situationOf(live)) ? undefined : "Nothing that runs has a change to take over",
      run: () => void live.trials.takeOver(),
    },
    { id: "stop", label: "Stop", group: "Run", icon: "rewind", shortcut: kStopKey, run: () => void live.trials.stop() },
    {
      id: "field-toggle",
      label: showsField ? "Hide the movement field" : "Movement field of the selection",
      group: "Run",
      shortcut: kFieldKey,
      blocked: live.model.get("scene") ? undefined : "Run it first",
      run: () => {
        showPane(live.designer);
        live.store.setState({ showsField: !showsField, field: null, fieldError: "" });
      },
    },
    ...timeActions(live),
    { id: "to-console", label: "Open the run in the console", group: "Run", run: () => live.operator.openConsole() },
    keyed(
      menu.find(({ id }) => id.startsWith("break")),
      "break",
      "Breakpoint on the selection",
      kBreakKey,
    ),
    keyed(
      menu.find(({ id }) => id === "pin"),
      "pin",
      "Pin a probe",
      kPinKey,
    ),
  ];
}

function keyed(found: Action | undefined, id: string, label: string, shortcut: string): Action {
  if (found) return { ...found, id, shortcut };
  return { id, label, group: "Run", shortcut, blocked: "Select a transition, a wire or a node", run: () => {} };
}
