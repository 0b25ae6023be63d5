import { Button } from "../../ui/controls/controls.tsx";
import { showPanel } from "../session/layout.ts";
import { usePart, useSession } from "../session/session.ts";
import { kFailsafesPlace } from "./place.ts";
import { stateWord, summaryText, worstState } from "./standings.ts";
import { useStandings } from "./use_standings.ts";

/** How many rows of the table are armed, near, ...; opens the table. */
export function FailsafeSummary({ robot }: { robot: number }) {
  const { ui } = useSession();
  useStandings("failsafe-summary", [robot]);
  const standings = usePart("standings").get(robot);
  const text = summaryText(standings) || "none of its own";
  const { tone } = stateWord(worstState(standings));
  return (
    <Button
      tone="link"
      className={`failsafe-summary ${tone}`}
      onPress={() => ui.set("layout", showPanel(ui.get("layout"), kFailsafesPlace))}
    >
      {text}
    </Button>
  );
}
