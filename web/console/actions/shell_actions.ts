// The actions of the shell itself: one list behind menus, palette, shortcuts and the sheet that shows them.

import { kLayers, withLayer } from "../../core/map_settings.ts";
import type { Model } from "../../core/model.ts";
import { Control_Action, Status_Mode } from "../../core/protocol.ts";
import { kNothing, selectRobots } from "../../core/selection.ts";
import { actionSources, panels, tools } from "../extensions/extensions.ts";
import { mainButton } from "../mission/main_button.ts";
import { pressMainButton } from "../mission/press.ts";
import { situationOf } from "../mission/situation.ts";
import { neighbour } from "../mission/speed.ts";
import { nameOf, nextRedo, nextUndo } from "../session/history.ts";
import { firstLayout, kDocks, toggleDock, togglePanel } from "../session/layout.ts";
import {
  answer,
  askFirst,
  control,
  emergencyStop,
  passOperator,
  redo,
  save,
  setSpeed,
  takeOperator,
  undo,
} from "../session/orders.ts";
import type { Action } from "../session/registry.ts";
import type { Session } from "../session/session.ts";

export const kStopShortcut = "ctrl+.";

export function allActions(session: Session): Action[] {
  return [
    ...runActions(session),
    ...missionActions(session),
    ...editActions(session),
    ...mapActions(session),
    ...selectionActions(session),
    ...viewActions(session),
    ...peopleActions(session),
    ...actionSources.flatMap((source) => source(session)),
  ];
}

const kWatching = "Only the operator can do this: take control first.";

function operatorOnly(model: Model): string | undefined {
  return model.isOperator() ? undefined : kWatching;
}

function runActions(session: Session): Action[] {
  const main = mainButton(situationOf(session.model));
  return [
    {
      id: "stop",
      label: "Emergency stop",
      group: "Run",
      icon: "stop",
      shortcut: kStopShortcut,
      everywhere: true,
      run: () => void emergencyStop(session),
    },
    {
      id: "main",
      label: main.label,
      group: "Run",
      icon: main.icon,
      shortcut: "x",
      blocked: main.does.kind === "nothing" ? main.hint : undefined,
      run: () => pressMainButton(session),
    },
    ...stepActions(session),
    ...speedActions(session),
    ...questionActions(session),
  ];
}

function stepActions(session: Session): Action[] {
  const { model } = session;
  const mode = model.get("status")?.mode ?? Status_Mode.NO_MISSION;
  const noMission = mode === Status_Mode.NO_MISSION ? "No mission is loaded." : undefined;
  const blocked = operatorOnly(model) ?? noMission;
  const stands = mode === Status_Mode.STOPPED ? "Release the emergency stop first." : undefined;
  const run = (action: Control_Action) => () => control(session, action);
  return [
    {
      id: "step",
      label: "Single step of the mission, then stop",
      group: "Run",
      icon: "step",
      shortcut: "n",
      blocked: blocked ?? stands,
      run: run(Control_Action.SINGLE_STEP),
    },
    {
      id: "skip",
      label: "Skip a step",
      group: "Run",
      icon: "skip",
      shortcut: "shift+n",
      blocked: blocked ?? stands,
      run: run(Control_Action.SKIP_STEP),
    },
    {
      id: "cycle",
      label: "Single control cycle",
      group: "Run",
      icon: "cycle",
      shortcut: "c",
      blocked: blocked ?? stands,
      run: run(Control_Action.SINGLE_CYCLE),
    },
    {
      id: "rewind",
      label: "Rewind to the first step",
      group: "Run",
      icon: "rewind",
      blocked: blocked ?? stands,
      run: run(Control_Action.REWIND),
    },
    {
      id: "restart",
      label: "Restart the run",
      group: "Run",
      icon: "restart",
      blocked,
      run: () => askFirst(session, Control_Action.RESTART),
    },
    {
      id: "abort",
      label: "Abort the mission",
      group: "Run",
      icon: "abort",
      blocked: blocked ?? stands,
      run: () => askFirst(session, Control_Action.ABORT),
    },
  ];
}

function speedActions(session: Session): Action[] {
  const blocked = operatorOnly(session.model);
  const speed = session.model.get("status")?.speed ?? 1;
  return [
    {
      id: "faster",
      label: "Faster",
      group: "Run",
      icon: "gauge",
      shortcut: ">",
      blocked,
      run: () => setSpeed(session, neighbour(speed, 1)),
    },
    {
      id: "slower",
      label: "Slower",
      group: "Run",
      icon: "gauge",
      shortcut: "<",
      blocked,
      run: () => setSpeed(session, neighbour(speed, -1)),
    },
    {
      id: "real-time",
      label: "Speed of real time",
      group: "Run",
      icon: "gauge",
      blocked,
      run: () => setSpeed(session, 1),
    },
  ];
}

function questionActions(session: Session): Action[] {
  const oldest = session.model.get("questions")[0];
  const blocked = operatorOnly(session.model) ?? (oldest ? undefined : "Nothing is asked.");
  return [
    {
      id: "proceed",
      label: "Answer the oldest question: proceed",
      group: "Run",
      icon: "check",
      shortcut: "p",
      blocked,
      run: () => oldest && answer(session, oldest.id, true),
    },
    {
      id: "refuse",
      label: "Answer the oldest question: abort",
      group: "Run",
      icon: "abort",
      shortcut: "shift+p",
      blocked,
      run: () => oldest && answer(session, oldest.id, false),
    },
  ];
}

function missionActions(session: Session): Action[] {
  const { model, ui } = session;
  const noDocuments = model.get("documents")?.documents.length ? undefined : "No mission is open.";
  const clean = model.get("edits")?.isDirty ? undefined : "Everything is saved.";
  const blocked = operatorOnly(model);
  return [
    {
      id: "open",
      label: "Open a mission…",
      group: "Mission",
      icon: "folder",
      shortcut: "ctrl+o",
      blocked,
      run: () => ui.set("dialog", "open"),
    },
    { id: "new", label: "New mission…", group: "Mission", icon: "file", blocked, run: () => ui.set("dialog", "new") },
    {
      id: "save",
      label: "Save",
      group: "Mission",
      icon: "save",
      shortcut: "ctrl+s",
      everywhere: true,
      blocked: blocked ?? noDocuments ?? clean,
      run: () => save(session),
    },
    {
      id: "save-as",
      label: "Save as…",
      group: "Mission",
      icon: "save",
      shortcut: "ctrl+shift+s",
      everywhere: true,
      blocked: blocked ?? noDocuments,
      run: () => ui.set("dialog", "save-as"),
    },
  ];
}

function editActions(session: Session): Action[] {
  const history = session.ui.get("history");
  const edits = session.ui.missionEdits();
  const undoName = nameOf(nextUndo(history, edits));
  const redoName = nameOf(nextRedo(history, edits));
  return [
    {
      id: "undo",
      label: undoName ? `Undo ${undoName}` : "Undo",
      group: "Edit",
      icon: "undo",
      shortcut: "ctrl+z",
      blocked: undoName ? undefined : "There is nothing to undo.",
      run: () => undo(session),
    },
    {
      id: "redo",
      label: redoName ? `Redo ${redoName}` : "Redo",
      group: "Edit",
      icon: "redo",
      shortcut: "ctrl+shift+z",
      blocked: redoName ? undefined : "There is nothing to redo.",
      run: () => redo(session),
    },
  ];
}

function mapActions({ model, ui }: Session): Action[] {
  const map = ui.get("map");
  const blocked = map ? undefined : "The map is not shown.";
  const settings = model.get("map");
  const operator = model.isOperator();
  return [
    { id: "fit", label: "Fit the whole map", group: "Map", icon: "fit", shortcut: "f", blocked, run: () => map?.fit() },
    {
      id: "zoom-in",
      label: "Zoom in",
      group: "Map",
      icon: "plus",
      shortcut: "+",
      blocked,
      run: () => map?.zoom(Math.SQRT2),
    },
    {
      id: "zoom-out",
      label: "Zoom out",
      group: "Map",
      icon: "minus",
      shortcut: "-",
      blocked,
      run: () => map?.zoom(Math.SQRT1_2),
    },
    {
      id: "military",
      label: settings.military ? "Plain symbols" : "Military symbols",
      group: "Map",
      shortcut: "shift+m",
      run: () => ui.editMap(settings.military ? "plain symbols" : "military symbols", { military: !settings.military }),
    },
    ...kLayers.map(([layer, name]): Action => {
      const shown = settings.layers[layer];
      const words = `${shown ? "hide" : "show"} ${name.toLowerCase()}`;
      const label = words.charAt(0).toUpperCase() + words.slice(1);
      return {
        id: `layer-${layer}`,
        label,
        group: "Map",
        ...(layer === "trails" ? { shortcut: "t" } : layer === "vectors" ? { shortcut: "v" } : {}),
        run: () => ui.editMap(words, { layers: withLayer(settings, layer, !shown).layers }),
      };
    }),
    {
      id: "tool-select",
      label: "Select and move about",
      group: "Tools",
      icon: "pointer",
      shortcut: "s",
      run: () => ui.set("tool", ""),
    },
    ...tools.map(
      (tool): Action => ({
        id: `tool-${tool.id}`,
        label: tool.label,
        group: "Tools",
        icon: tool.icon,
        ...(tool.shortcut ? { shortcut: tool.shortcut } : {}),
        blocked: tool.forOperator && !operator ? kWatching : blocked,
        run: () => ui.set("tool", ui.get("tool") === tool.id ? "" : tool.id),
      }),
    ),
  ];
}

function selectionActions({ model, ui }: Session): Action[] {
  const selection = model.get("selection");
  const roster = model.get("roster");
  const map = ui.get("map");
  const first = selection.robots[0];
  const none = selection.robots.length + selection.items.length > 0 ? undefined : "Nothing is selected.";
  const noRobots = roster.robots.length > 0 ? undefined : "There are no robots.";
  const next = (by: number) => () => {
    const ids = roster.robots.map((robot) => robot.id);
    const at = first === undefined ? (by > 0 ? -1 : 0) : ids.indexOf(first);
    const id = ids[(at + by + ids.length) % ids.length];
    if (id !== undefined) model.select(selectRobots([id]));
  };
  return [
    {
      id: "next-robot",
      label: "Select the next robot",
      group: "Selection",
      shortcut: "]",
      blocked: noRobots,
      run: next(1),
    },
    {
      id: "previous-robot",
      label: "Select the previous robot",
      group: "Selection",
      shortcut: "[",
      blocked: noRobots,
      run: next(-1),
    },
    {
      id: "select-all",
      label: "Select all robots",
      group: "Selection",
      shortcut: "ctrl+a",
      blocked: noRobots,
      run: () => model.select(selectRobots(roster.robots.map((robot) => robot.id))),
    },
    {
      id: "select-none",
      label: "Clear the selection",
      group: "Selection",
      shortcut: "escape",
      blocked: none,
      run: () => model.select(kNothing),
    },
    {
      id: "centre",
      label: "Show the selection on the map",
      group: "Selection",
      icon: "centre",
      shortcut: ".",
      blocked: none,
      run: () => map?.fitSelection(),
    },
    {
      id: "follow",
      label: map?.following ? "Stop following" : "Follow the selection",
      group: "Selection",
      icon: "follow",
      shortcut: "shift+f",
      blocked: map?.following || first !== undefined ? undefined : "No robot is selected.",
      run: () => {
        if (map?.following) map.follow(null);
        else if (selection.unit) map?.follow({ unit: selection.unit });
        else if (first !== undefined) map?.follow({ robot: first });
      },
    },
  ];
}

function viewActions({ ui }: Session): Action[] {
  const layout = ui.shownLayout;
  return [
    {
      id: "palette",
      label: "Search everything…",
      group: "View",
      icon: "search",
      shortcut: "ctrl+k",
      everywhere: true,
      run: () => ui.set("dialog", ui.get("dialog") === "palette" ? "" : "palette"),
    },
    {
      id: "shortcuts",
      label: "Keyboard shortcuts",
      group: "View",
      shortcut: "?",
      run: () => ui.set("dialog", "shortcuts"),
    },
    ...panels.map(
      (panel): Action => ({
        id: `panel-${panel.id}`,
        label: `${panel.title} panel`,
        group: "View",
        icon: panel.icon,
        ...(panel.shortcut ? { shortcut: panel.shortcut } : {}),
        run: () => ui.set("layout", togglePanel(ui.get("layout"), ui.shownLayout, panels, panel)),
      }),
    ),
    ...kDocks.map(
      (dock): Action => ({
        id: `dock-${dock}`,
        label: `${layout.docks[dock].open ? "Close" : "Open"} the ${dock} side`.replace("bottom side", "drawer"),
        group: "View",
        shortcut: { left: "ctrl+b", right: "ctrl+shift+b", bottom: "ctrl+j" }[dock],
        run: () => ui.set("layout", toggleDock(ui.get("layout"), ui.shownLayout, dock)),
      }),
    ),
    {
      id: "command-line",
      label: "Type a command",
      group: "View",
      icon: "command",
      shortcut: "/",
      run: () => document.getElementById("command-line")?.focus(),
    },
    {
      id: "reset-layout",
      label: "Reset the layout",
      group: "View",
      run: () => ui.set("layout", firstLayout(window.innerWidth)),
    },
    ...(["light", "dark", "auto"] as const).map(
      (theme): Action => ({
        id: `theme-${theme}`,
        label: theme === "auto" ? "Colours as the system has them" : `${theme === "light" ? "Light" : "Dark"} colours`,
        group: "View",
        icon: "sun",
        blocked: ui.get("theme") === theme ? "They are chosen." : undefined,
        run: () => ui.set("theme", theme),
      }),
    ),
  ];
}

function peopleActions(session: Session): Action[] {
  const { model, ui } = session;
  const clients = model.get("clients");
  const isOperator = model.isOperator();
  const asks = clients?.clients.find((client) => client.id === clients.asks);
  return [
    {
      id: "take-control",
      label: "Take control",
      group: "People",
      icon: "hand",
      blocked: isOperator ? "You are the operator." : undefined,
      run: () => takeOperator(session),
    },
    {
      id: "hand-over",
      label: "Hand over control…",
      group: "People",
      icon: "person",
      blocked: isOperator ? undefined : "You are not the operator.",
      run: () => ui.set("dialog", "hand-over"),
    },
    ...(isOperator && asks
      ? ([
          {
            id: "give-control",
            label: `Give control to ${asks.name || `browser ${asks.id}`}`,
            group: "People",
            icon: "check",
            run: () => passOperator(session, asks.id),
          },
          {
            id: "decline-control",
            label: `Decline the request of ${asks.name || `browser ${asks.id}`}`,
            group: "People",
            icon: "close",
            run: () => passOperator(session, 0),
          },
        ] satisfies Action[])
      : []),
  ];
}
