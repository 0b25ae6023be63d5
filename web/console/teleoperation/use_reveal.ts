import { useEffect, useRef } from "react";
import { isShown, showPanel } from "../session/layout.ts";
import type { Panel } from "../session/registry.ts";
import { useIsElsewhen, useReading, useSession } from "../session/session.ts";

/** Opens the sticks when one more unit comes under teleoperation, whoever began it. */
export function useRevealTeleoperation(panels: readonly Panel[]): void {
  const { ui } = useSession();
  const units = useReading(["status"], (model) =>
    (model.get("status")?.teleoperations ?? []).map((each) => each.unit).join("\n"),
  );
  const before = useRef("");
  // Who looks at another moment takes nothing up there.
  const isElsewhen = useIsElsewhen();
  useEffect(() => {
    if (isElsewhen) return;
    const known = new Set(before.current.split("\n"));
    before.current = units;
    const hasNew = units !== "" && units.split("\n").some((unit) => !known.has(unit));
    const panel = panels.find((one) => one.id === "teleoperation");
    if (!hasNew || !panel || isShown(ui.shownLayout, panels, panel.id)) return;
    ui.set("layout", showPanel(ui.get("layout"), panel));
  }, [isElsewhen, units, panels, ui]);
}

/** How many units are steered, on the panel's button. */
export function useSteeredUnits(): number {
  return useReading(["status"], (model) => model.get("status")?.teleoperations.length ?? 0);
}
