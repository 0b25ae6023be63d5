// All that can be done, as a sheet of its keys.
import type { IconName } from "../controls/icons.tsx";
import { DialogBox } from "../controls/menus.tsx";
import { shownShortcut } from "./keys.ts";

export interface Command {
  id: string;
  /** As in a menu: `Pause`, `Fit the map`. */
  label: string;
  group: string;
  icon?: IconName;
  /** As in keys.ts: `ctrl+shift+z`, `f`. */
  shortcut?: string;
  /** Why it can't be done now, as a sentence; nothing: it can. */
  blocked?: string | undefined;
  run: () => void;
}

interface CommandsProps {
  commands: readonly Command[];
  onClose: () => void;
}

interface KeySheetProps extends CommandsProps {
  /** What the mouse does: the heading, and what is done by what. */
  pointer: { title: string; rows: readonly (readonly [string, string])[] };
}

/** The commands that have a key, by their groups. */
export function KeySheet({ commands, pointer, onClose }: KeySheetProps) {
  const groups = new Map<string, (readonly [string, string])[]>();
  for (const { group, label, shortcut } of commands)
    if (shortcut) groups.set(group, [...(groups.get(group) ?? []), [shownShortcut(shortcut), label]]);
  return (
    <DialogBox title="Keyboard shortcuts" onClose={onClose} width={900}>
      <div className="sheet">
        {[...groups, [pointer.title, pointer.rows] as const].map(([title, rows]) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {rows.map(([keys, does]) => (
                <div key={`${keys} ${does}`}>
                  <dt>{does}</dt>
                  <dd>
                    <kbd>{keys}</kbd>
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </DialogBox>
  );
}
