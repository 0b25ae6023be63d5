// The mission's table of failsafes: how it stands for what is selected, and what it would do.
import { Status_Mode } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { count } from "../../ui/words/format.ts";
import { usePart, useSession } from "../session/session.ts";
import { FailsafeTable } from "./failsafe_table.tsx";
import { useStandings } from "./use_standings.ts";
import { WhatIf } from "./what_if_form.tsx";
import "./failsafes.css";

export function FailsafesPanel() {
  const rows = usePart("failsafes");
  const status = usePart("status");
  const selection = usePart("selection");
  const roster = usePart("roster");
  useStandings("failsafes", rows.length > 0 ? selection.robots : []);
  if (rows.length === 0)
    return <NoRows hasMission={(status?.mode ?? Status_Mode.NO_MISSION) !== Status_Mode.NO_MISSION} />;
  const tried = selection.robots[0] ?? roster.robots[0]?.id;
  return (
    <div className="rows tab-body failsafes">
      <section aria-label="The table">
        <p className="failsafe-whose">
          <Whose robots={selection.robots} unit={selection.unit} />
        </p>
        <FailsafeTable robots={selection.robots} />
        <p className="small muted">
          The first that holds acts. Above all of them stands the emergency stop; a robot whose program fails stands.
        </p>
      </section>
      {tried !== undefined && <WhatIf key={rows.map((row) => row.statement).join()} robot={tried} />}
    </div>
  );
}

function Whose({ robots, unit }: { robots: readonly number[]; unit: string }) {
  const roster = usePart("roster");
  const [first] = robots;
  if (first === undefined)
    return <span className="muted">Select a robot or a unit to see how each row stands for it.</span>;
  const name =
    unit !== "" ? `Unit ${unit}` : robots.length === 1 ? roster.nameOf(first) : count(robots.length, "robot");
  return (
    <>
      For <strong>{name}</strong>
      {robots.length > 1 && <span className="muted">: of each row the robot that is worst off</span>}
    </>
  );
}

const kSample = [
  "FAILSAFE IN-CONTACT AFTER 0.5 HOLD",
  "FAILSAFE STUCK AFTER 60 STOP",
  "FAILSAFE LINK-LOST AFTER 5 RETURN",
];

function NoRows({ hasMission }: { hasMission: boolean }) {
  const { ui } = useSession();
  const [mission] = usePart("documents")?.documents ?? [];
  if (!hasMission)
    return (
      <div className="empty">
        <p>There is no table of failsafes.</p>
        <p className="small">No mission is open, or the one that is open has errors or is still getting ready.</p>
      </div>
    );
  return (
    <div className="empty failsafes">
      <p>This mission has no failsafes.</p>
      <p className="small">
        What a robot does when something is wrong, whatever its program wants then, stands in the mission's preamble,
        the highest rank first:
      </p>
      <div className="failsafe-sample">
        {kSample.map((line) => (
          <code key={line}>{line}</code>
        ))}
      </div>
      <p className="small">
        <code>FAILSAFE OUTSIDE Field HOLD</code> keeps robots within a closed BOUNDARY of the overlay.
      </p>
      {mission && (
        <Button icon="text" onPress={() => ui.set("reveal", { document: mission.path, line: 1 })}>
          Open the text
        </Button>
      )}
    </div>
  );
}
