// All commands by a few letters; the sheet of shortcuts.
import { shownShortcut } from "../../console/actions/keys.ts";
import { ranked } from "../../console/actions/search.ts";
import { Icon } from "../../console/ui/icons.tsx";
import { DialogBox } from "../../console/ui/menus.tsx";
import { Chooser } from "../palette/chooser.tsx";
import { useDesigner } from "../use.ts";
import type { Action, ActionGroup } from "./action.ts";
import { allActions } from "./all_actions.ts";

export function Commands() {
  const designer = useDesigner();
  const actions = allActions(designer).filter((one) => one.id !== "commands" && !/^(nudge|push|walk)-/.test(one.id));
  return (
    <Chooser
      title="All commands"
      placeholder="What do you want to do?"
      find={(query) =>
        ranked(query, actions, (one) => `${one.label} ${one.group}`).map((one) => ({
          id: one.id,
          label: one.label,
          tail: one.shortcut ? shownShortcut(one.shortcut) : one.group,
          ...(one.blocked ? { blocked: one.blocked } : {}),
          ...(one.icon ? { icon: <Icon name={one.icon} /> } : {}),
        }))
      }
      onChoose={(id) => actions.find((one) => one.id === id)?.run()}
      onClose={() => designer.store.setState({ dialog: "" })}
    />
  );
}

const kMouse: readonly (readonly [string, string])[] = [
  ["Drag from an output", "Draw a wire; let go in the open to place what it leads to"],
  ["Drag the end of a wire", "Lead it to another input, or cut it"],
  ["Alt and click on a wire", "Cut it"],
  ["Double-click", "Look inside"],
  ["Drag in the open, Shift click", "Select several"],
  ["Right or middle button, wheel", "Move the canvas"],
  ["Ctrl and wheel, pinch", "Zoom"],
];

export function ShortcutSheet() {
  const designer = useDesigner();
  const groups = new Map<ActionGroup, Action[]>();
  for (const one of allActions(designer)) {
    if (one.shortcut && !/^(push|nudge|walk)-(right|up|down)/.test(one.id)) {
      groups.set(one.group, [...(groups.get(one.group) ?? []), one]);
    }
  }
  return (
    <DialogBox title="Keyboard shortcuts" onClose={() => designer.store.setState({ dialog: "" })} width={900}>
      <div className="sheet">
        {[...groups].map(([group, actions]) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {actions.map((one) => (
                <div key={one.id}>
                  <dt>{one.label.replace(/ left$/, " (all arrows)")}</dt>
                  <dd>
                    <kbd>{shownShortcut(one.shortcut!).replace("arrowleft", "←")}</kbd>
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section>
          <h3>Mouse</h3>
          <dl>
            {kMouse.map(([keys, does]) => (
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
