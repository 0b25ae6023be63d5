import { useEffect } from "react";
import { panels } from "../extensions.ts";
import { usePart, useSession, useUi } from "../session.ts";
import { dockOf, isShown, showPanel } from "./layout.ts";

/** Opens the text editor when something is to be shown in it, and the selection panel with the first selection. */
export function useRevealing(): void {
  const { ui } = useSession();
  const reveal = useUi("reveal");
  const hasSelection = usePart("selection").robots.length > 0;
  useEffect(() => {
    const panel = panels.find((one) => one.id === "text");
    if (!reveal || !panel) return;
    ui.set("document", reveal.document);
    const layout = ui.get("layout");
    if (!isShown(layout, panels, panel.id)) ui.edit(showPanel(layout, panel));
  }, [reveal, ui]);
  useEffect(() => {
    const panel = panels.find((one) => one.id === "selection");
    const layout = ui.get("layout");
    if (!hasSelection || !panel || layout.docks[dockOf(layout, panel)].open) return;
    // The map makes room by itself: this is no edit of the person's layout.
    ui.previewLayout(showPanel(layout, panel).layout);
  }, [hasSelection, ui]);
}
