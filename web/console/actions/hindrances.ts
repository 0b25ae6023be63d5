// Why something can't be done now.
import { Status_Mode } from "../../core/protocol.ts";
import type { Hindrance } from "../../ui/commands/declared.ts";
import { isGettingReady } from "../mission/state.ts";
import { elsewhen } from "../session/elsewhen.ts";
import type { Session } from "../session/session.ts";

type Why = Hindrance<Session>;

export const onlyWatching: Why = ({ model }) =>
  elsewhen(model) ?? (model.isOperator() ? undefined : "Only the operator can do this: take control first.");

export const noMission: Why = ({ model }) => {
  const status = model.get("status");
  if (isGettingReady(status)) return "The mission is still getting ready.";
  return (status?.mode ?? Status_Mode.NO_MISSION) === Status_Mode.NO_MISSION ? "No mission is loaded." : undefined;
};

export const emergencyStopped: Why = ({ model }) =>
  model.get("status")?.mode === Status_Mode.STOPPED ? "Release the emergency stop first." : undefined;

export const noDocuments: Why = ({ model }) =>
  model.get("documents")?.documents.length ? undefined : "No mission is open.";

export const allSaved: Why = ({ model }) => (model.get("edits")?.isDirty ? undefined : "Everything is saved.");

export const noMap: Why = ({ ui }) => (ui.get("map") ? undefined : "The map is not shown.");

export const nothingSelected: Why = ({ model }) => {
  const { robots, items } = model.get("selection");
  return robots.length + items.length > 0 ? undefined : "Nothing is selected.";
};

export const noRobots: Why = ({ model }) =>
  model.get("roster").robots.length > 0 ? undefined : "There are no robots.";
