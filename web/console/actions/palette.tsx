// Everything that can be done, found by typing a few letters.
import { useMemo, useRef, useState } from "react";
import { Dialog, Modal, ModalOverlay } from "react-aria-components";
import { useSession } from "../session.ts";
import { Icon } from "../ui/icons.tsx";
import { shownShortcut } from "./keys.ts";
import { ranked } from "./search.ts";
import { allActions } from "./shell_actions.ts";
import "./actions.css";

const kMostShown = 60;

export function Palette() {
  const session = useSession();
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const actions = useMemo(() => allActions(session).filter((action) => action.id !== "palette"), [session]);
  const found = ranked(query, actions, (action) => `${action.label} ${action.group}`).slice(0, kMostShown);
  const close = () => session.ui.set("dialog", "");
  const run = (place: number) => {
    const action = found[place];
    if (!action || action.blocked) return;
    close();
    // After the dialog has given the focus back, so that the action may move it.
    setTimeout(action.run, 0);
  };
  const go = (place: number) => {
    const next = Math.max(0, Math.min(found.length - 1, place));
    setAt(next);
    list.current?.children[next]?.scrollIntoView({ block: "nearest" });
  };
  const keys: Record<string, () => void> = {
    ArrowDown: () => go(at + 1),
    ArrowUp: () => go(at - 1),
    PageDown: () => go(at + 8),
    PageUp: () => go(at - 8),
    Enter: () => run(at),
  };
  return (
    <ModalOverlay className="scrim" isOpen isDismissable onOpenChange={(open) => !open && close()}>
      <Modal className="dialog">
        <Dialog aria-label="All commands">
          <div className="palette-field">
            <Icon name="search" />
            <input
              autoFocus
              role="combobox"
              aria-label="Search all commands"
              aria-expanded="true"
              aria-controls="palette-list"
              aria-activedescendant={found[at] ? `palette-${found[at].id}` : undefined}
              placeholder="What do you want to do?"
              value={query}
              onChange={(event) => {
                setQuery(event.target.value);
                setAt(0);
              }}
              onKeyDown={(event) => {
                const act = keys[event.key];
                if (!act) return;
                event.preventDefault();
                act();
              }}
            />
            <kbd>Esc</kbd>
          </div>
          <div className="palette-list" id="palette-list" role="listbox" aria-label="Commands" ref={list} tabIndex={-1}>
            {found.map((action, place) => (
              // biome-ignore lint/a11y/useKeyWithClickEvents: keys go to the field, which holds the focus
              <div
                key={action.id}
                id={`palette-${action.id}`}
                role="option"
                tabIndex={-1}
                className="palette-item"
                aria-selected={place === at}
                aria-disabled={action.blocked !== undefined}
                onClick={() => run(place)}
                onMouseMove={() => setAt(place)}
              >
                {action.icon ? <Icon name={action.icon} /> : <span className="icon-room" />}
                <span className="grow">
                  {action.label}
                  {action.blocked && <span className="small muted"> · {action.blocked}</span>}
                </span>
                <span className="small muted">{action.group}</span>
                {action.shortcut && <kbd>{shownShortcut(action.shortcut)}</kbd>}
              </div>
            ))}
            {found.length === 0 && <p className="empty">Nothing is called that.</p>}
          </div>
        </Dialog>
      </Modal>
    </ModalOverlay>
  );
}
