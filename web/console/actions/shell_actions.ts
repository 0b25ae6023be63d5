// All that can be done: one list behind menus, palette, shortcuts and the sheet that shows them. Each action is a row of a
// table, those of panels are the panels' own.
import { actionsOf } from "../../ui/commands/declared.ts";
import { actionSources } from "../extensions/extensions.ts";
import type { Action, ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { kTimeTable } from "../time/time_actions.ts";
import { kMapTable, kToolTable } from "./map_actions.ts";
import { kEditTable, kMissionTable } from "./mission_actions.ts";
import { kPeopleTable, requestTable } from "./people_actions.ts";
import { answerTable, kRunTable } from "./run_actions.ts";
import { kSelectionTable } from "./selection_actions.ts";
import { kViewTable } from "./view_actions.ts";

export function allActions(session: Session): Action[] {
  const tables: readonly ActionTable[] = [
    kRunTable,
    answerTable(session),
    kTimeTable,
    kMissionTable,
    kEditTable,
    kMapTable,
    kToolTable,
    kSelectionTable,
    kViewTable,
    kPeopleTable,
    requestTable(session),
  ];
  return [
    ...tables.flatMap((table) => actionsOf(table, session)),
    ...actionSources.flatMap((source) => source(session)),
  ];
}
