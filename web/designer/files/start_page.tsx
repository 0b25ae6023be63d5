// Without a document: what there is to open, and how to begin.
import { useState } from "react";
import { Confirm } from "../../ui/controls/confirm.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon, type IconName } from "../../ui/controls/icons.tsx";
import { shownTitle } from "../../ui/files/paths.ts";
import { isNew } from "../session/titles.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { startTour } from "../tour/start.ts";
import { type Entry, recentEntries, shownPlace } from "./unsaved.ts";
import "../../ui/files/start.css";
import { discard } from "../session/documents.ts";

export function StartPage() {
  const designer = useDesigner();
  const hello = usePart((state) => state.hello);
  const documents = usePart((state) => state.documents);
  const [doomed, setDoomed] = useState<Entry | null>(null);
  if (!hello) {
    return (
      <main className="start">
        <p className="empty">Connecting…</p>
      </main>
    );
  }
  return (
    <main className="start">
      <div className="start-box wide">
        <header>
          <h1>What shall the robots do?</h1>
          <p className="muted">
            Project folder <span className="mono">{hello.folder}</span>
          </p>
        </header>
        <div className="columns">
          <Button tone="primary" className="large" icon="why" onPress={() => void startTour(designer)}>
            Guided first tour
          </Button>
          <Button className="large" icon="plus" onPress={() => void designer.navigation.open("", "")}>
            New configuration
          </Button>
          <Button className="large" icon="folder" onPress={() => designer.store.setState({ dialog: "open" })}>
            Open…
          </Button>
        </div>
        <div className="start-lists">
          <Entries
            title="Recent"
            icon="restart"
            entries={recentEntries(hello.recent, documents)}
            none="What you have opened appears here."
            canDiscard={({ path }) => isNew(path) || hello.onlyKept.includes(path)}
            onDiscard={setDoomed}
          />
          <Entries
            title="In this project"
            icon="file"
            entries={hello.files}
            none="This folder has no configurations yet."
          />
          <Entries title="Examples" icon="map" entries={hello.examples} none="No examples are installed." />
        </div>
      </div>
      {doomed && <DiscardDialog entry={doomed} onClose={() => setDoomed(null)} />}
    </main>
  );
}

/** Nothing brings it back, so that it is asked first. */
function DiscardDialog({ entry, onClose }: { entry: Entry; onClose: () => void }) {
  const designer = useDesigner();
  const name = shownTitle(entry);
  const throwAway = async () => {
    if (await discard(designer, entry.path)) designer.say(`Threw ${name} away`);
  };
  return (
    <Confirm
      title={`Throw ${name} away?`}
      no="Keep it"
      yes="Throw it away"
      isCareful
      onYes={() => void throwAway()}
      onClose={onClose}
    >
      <p>{isNew(entry.path) ? "It was never saved" : "Its file is gone"}: what it holds is lost.</p>
    </Confirm>
  );
}

function Entries({
  title,
  icon,
  entries,
  none,
  canDiscard,
  onDiscard,
}: {
  title: string;
  icon: IconName;
  entries: readonly Entry[];
  none: string;
  canDiscard?: (entry: Entry) => boolean;
  onDiscard?: (entry: Entry) => void;
}) {
  const designer = useDesigner();
  const documents = usePart((state) => state.documents);
  return (
    <section aria-label={title}>
      <h2>{title}</h2>
      {entries.length === 0 && <p className="small muted">{none}</p>}
      <ul>
        {entries.map((entry) => (
          <li key={entry.path} className="start-line">
            <Button tone="quiet" className="start-entry" onPress={() => void designer.navigation.open(entry.path)}>
              <Icon name={icon} />
              <span className="grow">
                <span className="start-title">{shownTitle(entry)}</span>
                {entry.about !== "" && <span className="small start-about">{entry.about}</span>}
                <span className="small muted ellipsis">{shownPlace(entry, documents)}</span>
              </span>
            </Button>
            {onDiscard && canDiscard?.(entry) && (
              <IconButton icon="close" label={`Throw ${shownTitle(entry)} away`} onPress={() => onDiscard(entry)} />
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
