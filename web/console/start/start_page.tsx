import type { Project_Entry } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { shownPath, shownTitle } from "../../ui/files/paths.ts";
import { openMission } from "../session/orders.ts";
import { useIsOperator, usePart, useSession } from "../session/session.ts";
import "../../ui/files/start.css";

/** Without a mission: what there is to open, and how to begin one. */
export function StartPage() {
  const { ui } = useSession();
  const project = usePart("project");
  const isOperator = useIsOperator();
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
            isDisabled={!isOperator}
            onPress={() => ui.set("dialog", "new")}
          >
            New mission
          </Button>
          <Button className="large" icon="folder" isDisabled={!isOperator} onPress={() => ui.set("dialog", "open")}>
            Open…
          </Button>
        </div>
        {!isOperator && <p className="notice">You are watching. The operator chooses the mission.</p>}
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

interface EntriesProps {
  title: string;
  icon: "restart" | "file" | "map";
  entries: readonly Project_Entry[];
  none: string;
}

function Entries({ title, icon, entries, none }: EntriesProps) {
  const session = useSession();
  const isOperator = useIsOperator();
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
              isDisabled={!isOperator}
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
