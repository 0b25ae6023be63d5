import type { Action, ActionGroup } from "../registry.ts";
import { useSession } from "../session.ts";
import { DialogBox } from "../ui/menus.tsx";
import { shownShortcut } from "./keys.ts";
import { allActions } from "./shell_actions.ts";
import "./actions.css";

const kMapKeys: readonly (readonly [string, string])[] = [
  ["Arrow keys", "Move the map, while it has the focus"],
  ["Wheel, pinch", "Zoom"],
  ["Right or middle button, space and drag", "Move the map"],
  ["Shift and click", "Add to the selection"],
];

export function ShortcutSheet() {
  const session = useSession();
  const groups = new Map<ActionGroup, Action[]>();
  for (const action of allActions(session)) {
    if (action.shortcut) groups.set(action.group, [...(groups.get(action.group) ?? []), action]);
  }
  return (
    <DialogBox title="Keyboard shortcuts" onClose={() => session.ui.set("dialog", "")} width={860}>
      <div className="sheet">
        {[...groups].map(([group, actions]) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {actions.map((action) => (
                <div key={action.id}>
                  <dt>{action.label}</dt>
                  <dd>
                    <kbd>{shownShortcut(action.shortcut as string)}</kbd>
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section>
          <h3>On the map</h3>
          <dl>
            {kMapKeys.map(([keys, does]) => (
              <div key={keys}>
                <dt>{does}</dt>
                <dd>
                  <kbd>{keys}</kbd>
                </dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </DialogBox>
  );
}
