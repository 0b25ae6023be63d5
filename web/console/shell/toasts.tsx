// Alerts of the log that want to be seen at once, until they are dismissed.

import { Log_Kind } from "../../core/protocol.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { duration } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { openAlerts } from "../log/alerts.ts";
import { showPlace } from "../log/show_place.ts";
import { usePart, useSession, useUi } from "../session/session.ts";

const kMostShown = 20;

export function Toasts() {
  const session = useSession();
  const { ui } = session;
  const log = usePart("log");
  const to = useUi("dismissedTo");
  const dismissed = useUi("dismissed");
  const isUnfolded = useUi("alertsUnfolded");
  const after = usePart("alertsAfter");
  const alerts = openAlerts(log, to > after ? to : after, dismissed);
  const shown = alerts.slice(isUnfolded ? -kMostShown : -1).reverse();
  const hidden = alerts.length - shown.length;
  const dismissAll = () => {
    ui.set("dismissedTo", log.at(-1)?.number ?? 0n);
    ui.set("alertsUnfolded", false);
  };
  return (
    <section className="toasts" aria-label="Alerts" aria-live="polite">
      {alerts.length > 1 && (
        <div className="toast-all">
          <Button aria-expanded={isUnfolded} onPress={() => ui.set("alertsUnfolded", !isUnfolded)}>
            {isUnfolded ? (hidden > 0 ? `Newest alone (${hidden} older)` : "Newest alone") : `${hidden} more`}
          </Button>
          <Button onPress={dismissAll}>Dismiss all</Button>
        </div>
      )}
      {shown.map((entry) => (
        <div key={String(entry.number)} className={`toast ${entry.kind === Log_Kind.STUCK ? "" : "danger"}`}>
          <p>
            {sentence(entry.text)} <span className="muted small number">{duration(entry.time)}</span>
            {(entry.place || entry.robot !== 0) && (
              <>
                {" "}
                <Button tone="link" onPress={() => showPlace(session, entry)}>
                  Show
                </Button>
              </>
            )}
          </p>
          <IconButton
            icon="close"
            label="Dismiss"
            onPress={() => ui.set("dismissed", new Set([...dismissed, entry.number]))}
          />
        </div>
      ))}
    </section>
  );
}
