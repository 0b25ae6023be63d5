// What is selected, and how the map follows it.
import { kNothing, selectRobots } from "../../core/selection.ts";
import { faulted } from "../robots/robot_state.ts";
import { replaceRobots } from "../session/orders.ts";
import type { ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { noRobots, nothingSelected, onlyWatching } from "./hindrances.ts";

export const kSelectionTable: ActionTable = {
  group: "Selection",
  rows: [
    {
      id: "next-robot",
      label: "Select the next robot",
      shortcut: "]",
      unless: [noRobots],
      run: (session) => selectNeighbour(session, 1),
    },
    {
      id: "previous-robot",
      label: "Select the previous robot",
      shortcut: "[",
      unless: [noRobots],
      run: (session) => selectNeighbour(session, -1),
    },
    {
      id: "select-all",
      label: "Select all robots",
      shortcut: "ctrl+a",
      unless: [noRobots],
      run: ({ model }) => model.select(selectRobots(robotsOf(model))),
    },
    {
      id: "select-none",
      label: "Clear the selection",
      shortcut: "escape",
      unless: [nothingSelected],
      run: ({ model }) => model.select(kNothing),
    },
    {
      id: "centre",
      label: "Show the selection on the map",
      icon: "centre",
      shortcut: ".",
      unless: [nothingSelected],
      run: ({ ui }) => ui.get("map")?.framing.fitSelection(),
    },
    {
      id: "follow",
      label: ({ ui }) => (ui.get("map")?.framing.following ? "Stop following" : "Follow the selection"),
      icon: "follow",
      shortcut: "shift+f",
      unless: [nobodyToFollow],
      run: follow,
    },
    {
      id: "replace",
      label: "Replace the selected robots that have a fault",
      unless: [onlyWatching, nobodyFaulted],
      run: (session) => void replaceRobots(session, faultedOf(session)),
    },
  ],
};

function faultedOf({ model }: Session): readonly number[] {
  return faulted(model.robots, model.get("selection").robots);
}

function nobodyFaulted(session: Session): string | undefined {
  return faultedOf(session).length > 0 ? undefined : "No robot that is selected has a fault.";
}

function robotsOf(model: Session["model"]): number[] {
  return model.get("roster").robots.map(({ id }) => id);
}

/** The robot that is `by` places behind the first that is selected; without a selection the first or the last of all. */
function selectNeighbour({ model }: Session, by: 1 | -1): void {
  const ids = robotsOf(model);
  const [first] = model.get("selection").robots;
  const at = first === undefined ? (by > 0 ? -1 : 0) : ids.indexOf(first);
  const id = ids[(at + by + ids.length) % ids.length];
  if (id !== undefined) model.select(selectRobots([id]));
}

function nobodyToFollow({ model, ui }: Session): string | undefined {
  const isPossible = ui.get("map")?.framing.following || model.get("selection").robots.length > 0;
  return isPossible ? undefined : "No robot is selected.";
}

function follow({ model, ui }: Session): void {
  const map = ui.get("map");
  const { unit, robots } = model.get("selection");
  if (map?.framing.following) map.framing.follow(null);
  else if (unit) map?.framing.follow({ unit });
  else if (robots[0] !== undefined) map?.framing.follow({ robot: robots[0] });
}
