import { useEffect } from "react";
import { panels } from "../extensions/extensions.ts";
import { dockOf, isShown, leavesAll, showPanel } from "../session/layout.ts";
import { usePart, useSession, useUi } from "../session/session.ts";

/** Opens the text editor when something is to be shown in it, and the selection panel with the first selection. */
export function useRevealing(): void {
  const { ui } = useSession();
  const reveal = useUi("reveal");
  const hasSelection = usePart("selection").robots.length > 0;
  useEffect(() => {
    const panel = panels.find((one) => one.id === "text");
    if (!reveal || !panel) return;
    ui.set("document", reveal.document);
    if (!isShown(ui.shownLayout, panels, panel.id)) ui.set("layout", showPanel(ui.get("layout"), panel));
  }, [reveal, ui]);
  useEffect(() => {
    const panel = panels.find((one) => one.id === "selection");
    const layout = ui.get("layout");
    if (!hasSelection || !panel || layout.docks[dockOf(layout, panel)].open) return;
    if (leavesAll(layout, panel, ui.get("room"))) ui.set("layout", showPanel(layout, panel));
  }, [hasSelection, ui]);
}
