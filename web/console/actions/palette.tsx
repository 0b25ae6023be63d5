// The box in which everything of the console is found, and its keys.
import { useMemo } from "react";
import { selectItem, selectRobots, selectUnit } from "../../core/selection.ts";
import { KeySheet } from "../../ui/commands/commands.tsx";
import { commandsFound, Everything, resultsIn, type SearchResult } from "../../ui/commands/everything.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { openMission } from "../session/orders.ts";
import { type Session, usePart, useSession } from "../session/session.ts";
import { allActions } from "./shell_actions.ts";

const kOnTheMap = {
  title: "On the map",
  rows: [
    ["Arrow keys", "Move the map, while it has the focus"],
    ["Wheel, pinch", "Zoom"],
    ["Right or middle button, space and drag", "Move the map"],
    ["Shift and click", "Add to the selection"],
  ],
} as const;

type FoundBy = (query: string) => SearchResult[];

/** Commands, who drives, places, steps, files, other missions. */
export function Palette() {
  const session = useSession();
  const actions = useMemo(() => allActions(session).filter((action) => action.id !== "palette"), [session]);
  const finders: readonly FoundBy[] = [
    (query) => commandsFound(query, actions),
    useRosterFound(session),
    usePlacesFound(session),
    useStepsFound(session),
    useFilesFound(session),
  ];
  return (
    <Everything
      placeholder="Commands, units, robots, places, steps, files…"
      groups={(query) => finders.map((find) => find(query))}
      onClose={() => session.ui.set("dialog", "")}
    />
  );
}

function useRosterFound({ model }: Session): FoundBy {
  const roster = usePart("roster");
  return (query) => [
    ...resultsIn(
      query,
      roster.units,
      (unit) => unit.name,
      ({ name }) => ({
        id: `unit ${name}`,
        label: name,
        group: "Units and robots",
        tail: "unit",
        icon: <Icon name="follow" />,
        run: () => model.select(selectUnit(name, roster.robotsOf(name))),
      }),
    ),
    ...resultsIn(
      query,
      roster.robots,
      (robot) => `${roster.nameOf(robot.id)} ${robot.type}`,
      ({ id, type }) => ({
        id: `robot ${id}`,
        label: roster.nameOf(id),
        group: "Units and robots",
        tail: type,
        icon: <Icon name="follow" />,
        run: () => model.select(selectRobots([id])),
      }),
    ),
  ];
}

function usePlacesFound({ model, ui }: Session): FoundBy {
  const measures = usePart("scene")?.measures ?? [];
  const named = measures.map((measure, index) => ({ measure, index })).filter(({ measure }) => measure.name !== "");
  return (query) =>
    resultsIn(
      query,
      named,
      ({ measure }) => measure.name,
      ({ measure, index }) => ({
        id: `place ${index}`,
        label: measure.name,
        group: "Places",
        tail: "place",
        icon: <Icon name="centre" />,
        run: () => {
          model.select(selectItem({ kind: "measure", index }));
          const at = measure.points[0];
          if (at) ui.get("map")?.framing.centreOn(at);
        },
      }),
    );
}

function useStepsFound({ ui }: Session): FoundBy {
  const steps = usePart("plan")?.steps ?? [];
  return (query) =>
    resultsIn(
      query,
      steps,
      (step) => `Step ${step.label} ${step.commands.map((one) => one.text).join(" ")}`,
      (step) => ({
        id: `step ${step.document} ${step.line} ${step.label}`,
        label: `Step ${step.label}`,
        detail: step.commands.map((one) => one.text).join(" · "),
        group: "Steps",
        tail: step.document,
        icon: <Icon name="right" />,
        run: () => ui.set("reveal", { document: step.document, line: step.line }),
      }),
    );
}

function useFilesFound(session: Session): FoundBy {
  const documents = usePart("documents")?.documents ?? [];
  const missions = usePart("project")?.missions ?? [];
  return (query) => [
    ...resultsIn(
      query,
      documents,
      (document) => document.path,
      ({ path }) => ({
        id: `text ${path}`,
        label: path,
        group: "Files",
        tail: "open text",
        icon: <Icon name="file" />,
        run: () => session.ui.set("reveal", { document: path, line: 1 }),
      }),
    ),
    ...resultsIn(
      query,
      missions,
      ({ path, title }) => `${title} ${path}`,
      ({ path, title, about }) => ({
        id: `mission ${path}`,
        label: title || path,
        detail: about || path,
        group: "Files",
        tail: "mission",
        icon: <Icon name="file" />,
        run: () => void openMission(session, path),
      }),
    ),
  ];
}

export function ShortcutSheet() {
  const session = useSession();
  return <KeySheet commands={allActions(session)} pointer={kOnTheMap} onClose={() => session.ui.set("dialog", "")} />;
}
