import { kNotStarted } from "../../core/model.ts";
import type { Status_SilentMachine } from "../../core/protocol.ts";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { distance, duration, headingDegrees } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { FailsafeSummary } from "../failsafes/failsafe_summary.tsx";
import { faulted } from "../robots/robot_state.ts";
import { StatePill, useSilence } from "../robots/state_pill.tsx";
import { usePart, useSession } from "../session/session.ts";
import { VehicleFacts } from "../vehicles/vehicle_facts.tsx";
import { PlaceValue } from "./place_value.tsx";
import { ReplaceButton } from "./replace_button.tsx";
import { SaidThere } from "./said.tsx";
import { useMissing } from "./use_missing.ts";

/** One robot in short. */
export function RobotFacts({ id }: { id: number }) {
  const { model } = useSession();
  const detail = usePart("details").get(id);
  const time = usePart("time");
  const row = model.robots.rowOf(id);
  const roster = usePart("roster");
  const failsafes = usePart("failsafes");
  const missing = useMissing();
  const silence = useSilence(id);
  const silent = usePart("status")?.silentMachines.find((one) => one.name === detail?.machine);
  if (!detail || detail.life === kNotStarted) {
    return (
      <div className="rows tab-body">
        <StatePill robot={id} />
        <p className="muted">
          {row < 0 ? "Not started yet: START puts it where its outline stands on the map." : missing}
        </p>
        <VehicleFacts robot={id} />
      </div>
    );
  }
  const arrives =
    detail.arrival >= 0 ? `${duration(detail.arrival)} (in ${duration(Math.max(0, detail.arrival - time))})` : "–";
  return (
    <div className={`rows tab-body ${silence ? "old" : ""}`}>
      <div className="columns">
        <StatePill robot={id} />
        <span className="small muted">{typeText(roster.robot(id)?.type ?? "", roster.programOf(id))}</span>
      </div>
      {detail.fault && <p className="notice danger">{sentence(`it stands: ${detail.fault}`)}</p>}
      {faulted(model.robots, [id]).length > 0 && <ReplaceButton robots={[id]} />}
      {detail.failsafe && (
        <p className="notice hold" data-testid="failsafe">
          <code>{detail.failsafe}</code> acts, whatever its program wants. Another order or the stick takes over.
        </p>
      )}
      <VehicleFacts robot={id} />
      <FactList
        rows={[
          ["Command", detail.command || "none"],
          ...(detail.machine ? [["Machine", machineText(detail.machine, silent)] as const] : []),
          ["Assemblage", detail.task || "–"],
          ["State", detail.states.length > 0 ? detail.states.join(", ") : "–"],
          ["To the goal", distance(detail.remaining)],
          ["Arrives", arrives],
          ["Speed", `${detail.speed.toFixed(2)} m/s`],
          ["Heading", headingDegrees(detail.heading)],
          ["Place", <PlaceValue key="place" at={detail} />],
          ["Off its station", detail.station ? distance(detail.stationError) : "–"],
          ["Driven", distance(detail.distanceDriven)],
          ["Contacts", String(detail.contacts)],
          ...(failsafes.length > 0 ? [["Failsafes", <FailsafeSummary key="failsafes" robot={id} />] as const] : []),
          ["Carries", detail.carried ? `object ${detail.carried}` : "nothing"],
        ]}
      />
      {(detail.machine || detail.fault) && (
        <SaidThere key={`${id} ${detail.machine}`} robot={id} machine={detail.machine} />
      )}
    </div>
  );
}

function machineText(name: string, silent: Status_SilentMachine | undefined): string {
  return silent ? `${name}, silent for ${Math.floor(silent.silent)} s: values are as old` : name;
}

/** `ROBOT · program robot` */
function typeText(type: string, program: string): string {
  return [type, program && `program ${program}`].filter((word) => word !== "").join(" · ");
}
