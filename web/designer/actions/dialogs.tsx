// All commands by a few letters; the sheet of shortcuts.
import { CommandPalette, KeySheet } from "../../ui/commands/commands.tsx";
import { useDesigner } from "../session/use.ts";
import { allActions } from "./all_actions.ts";

const kMouse = {
  title: "Mouse",
  rows: [
    ["Drag from an output", "Draw a wire; let go in the open to place what it leads to"],
    ["Drag the end of a wire", "Lead it to another input, or cut it"],
    ["Alt and click on a wire", "Cut it"],
    ["Double-click", "Look inside"],
    ["Drag in the open, Shift click", "Select several"],
    ["Right or middle button, wheel", "Move the canvas"],
    ["Ctrl and wheel, pinch", "Zoom"],
  ],
} as const;

export function Commands() {
  const designer = useDesigner();
  const actions = allActions(designer).filter((one) => one.id !== "commands" && !/^(nudge|push|walk)-/.test(one.id));
  return <CommandPalette commands={actions} onClose={() => designer.store.setState({ dialog: "" })} />;
}

export function ShortcutSheet() {
  const designer = useDesigner();
  // Of four arrows that do the same one stands for all.
  const actions = allActions(designer)
    .filter((one) => !/^(push|nudge|walk)-(right|up|down)/.test(one.id))
    .map((one) => ({ ...one, label: one.label.replace(/ left$/, " (all arrows)") }));
  return <KeySheet commands={actions} pointer={kMouse} onClose={() => designer.store.setState({ dialog: "" })} />;
}
