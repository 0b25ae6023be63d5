import type { Project_Entry } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { nameOf, shownPath, shownTitle } from "../../ui/files/paths.ts";
import { duration, readableMessage } from "../../ui/words/format.ts";
import { openMission, order } from "../session/orders.ts";
import { useMayOrder, usePart, useSession } from "../session/session.ts";
import "../../ui/files/start.css";

/** Without a mission: what there is to open, and how to begin one. */
export function StartPage() {
  const { ui } = useSession();
  const project = usePart("project");
  const mayOrder = useMayOrder();
  if (!project) return null;
  return (
    <main className="start">
      <div className="start-box wide">
        <header>
          <h1>Which mission?</h1>
          <p className="muted">
            Project folder <span className="mono">{project.folder}</span>
          </p>
        </header>
        <div className="columns">
          <Button
            tone="primary"
            className="large"
            icon="plus"
            isDisabled={!mayOrder}
            onPress={() => ui.set("dialog", "new")}
          >
            New mission
          </Button>
          <Button className="large" icon="folder" isDisabled={!mayOrder} onPress={() => ui.set("dialog", "open")}>
            Open…
          </Button>
        </div>
        <Unfinished />
        {!mayOrder && <p className="notice">You are watching. The operator chooses the mission.</p>}
        <div className="start-lists">
          <Entries
            title="Recent"
            icon="restart"
            entries={project.recent}
            none="Missions that you have opened appear here."
          />
          <Entries
            title="In this project"
            icon="file"
            entries={project.missions}
            none="This folder has no missions yet."
          />
          <Entries title="Examples" icon="map" entries={project.examples} none="No examples are installed." />
        </div>
      </div>
    </main>
  );
}

/** Runs that mlab left when it ended or was killed. */
function Unfinished() {
  const session = useSession();
  const mayOrder = useMayOrder();
  const runs = usePart("journal")?.unfinished ?? [];
  if (runs.length === 0) return null;
  return (
    <section aria-label="Unfinished runs">
      <ul>
        {runs.map((run) => (
          <li key={run.name}>
            <Button
              tone="quiet"
              className="start-entry"
              isDisabled={!mayOrder}
              onPress={() => void order(session, { case: "continueRun", value: { name: run.name } })}
            >
              <Icon name="play" />
              <span className="grow">
                <span className="start-title">
                  {run.whyNot === "" || run.missionIsGone ? "Continue" : "Bring back"} ‘
                  {nameOf(run.mission).replace(/\.mdl$/, "")}’, stopped at {duration(run.time)}
                </span>
                <span className="small muted ellipsis">
                  {shownPath(run.mission)}, left {new Date(run.leftAt * 1000).toLocaleString()}
                </span>
                {run.whyNot !== "" && (
                  <span className="small muted start-why">
                    {run.missionIsGone
                      ? `The run can’t go on, because ${readableMessage(run.whyNot)}.`
                      : `The run does not go on: ${readableMessage(run.whyNot)}. Mission, log and people come back.`}
                  </span>
                )}
              </span>
            </Button>
          </li>
        ))}
      </ul>
    </section>
  );
}

interface EntriesProps {
  title: string;
  icon: "restart" | "file" | "map";
  entries: readonly Project_Entry[];
  none: string;
}

function Entries({ title, icon, entries, none }: EntriesProps) {
  const session = useSession();
  const mayOrder = useMayOrder();
  return (
    <section aria-label={title}>
      <h2>{title}</h2>
      {entries.length === 0 && <p className="small muted">{none}</p>}
      <ul>
        {entries.map((entry) => (
          <li key={entry.path}>
            <Button
              tone="quiet"
              className="start-entry"
              isDisabled={!mayOrder}
              onPress={() => void openMission(session, entry.path)}
            >
              <Icon name={icon} />
              <span className="grow">
                <span className="start-title">{shownTitle(entry)}</span>
                <span className="small muted ellipsis">{shownPath(entry.path)}</span>
              </span>
            </Button>
          </li>
        ))}
      </ul>
    </section>
  );
}
