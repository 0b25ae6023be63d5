// Everything that can be done in the console, and its keys.
import { useMemo } from "react";
import { CommandPalette, KeySheet } from "../../ui/commands/commands.tsx";
import { useSession } from "../session/session.ts";
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

export function Palette() {
  const session = useSession();
  const actions = useMemo(() => allActions(session).filter((action) => action.id !== "palette"), [session]);
  return <CommandPalette commands={actions} onClose={() => session.ui.set("dialog", "")} />;
}

export function ShortcutSheet() {
  const session = useSession();
  return <KeySheet commands={allActions(session)} pointer={kOnTheMap} onClose={() => session.ui.set("dialog", "")} />;
}
