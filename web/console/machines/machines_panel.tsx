// All machines of the fleet that carries the run's robots, and the way to each of them.
import type { Machines_Machine } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { count, readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { useIsElsewhen, usePart, useSession } from "../session/session.ts";
import { age, clockText, condition, healthText, linkText, othersText, versionText } from "./machine.ts";
import "./machines.css";

export function MachinesPanel() {
  const machines = usePart("machines");
  const isElsewhen = useIsElsewhen();
  if (!machines) {
    return (
      <div className="empty">
        <p>No fleet carries this run's robots: they live on the console's own machine.</p>
        <p className="small">
          <code>mlab run MISSION --robots fleet</code> lets the machines of a fleet carry them.
        </p>
      </div>
    );
  }
  if (machines.machines.length === 0) {
    return (
      <div className="empty">
        <p>Nobody is there.</p>
        <p className="small">{sentence(readableMessage(machines.hint))}</p>
      </div>
    );
  }
  return (
    <div className="rows tab-body machines">
      <p className="small muted">
        {count(machines.machines.length, "machine")} in the fleet {machines.fleet}
        {isElsewhen ? ", as it is now, not at the moment that is shown" : ""}
      </p>
      <ul className="machines-list">
        {machines.machines.map((machine) => (
          <MachineCard key={machine.name} machine={machine} />
        ))}
      </ul>
    </div>
  );
}

function MachineCard({ machine }: { machine: Machines_Machine }) {
  const own = usePart("welcome")?.version ?? "";
  const { word, tone, isOld } = condition(machine);
  return (
    <li className={`machine ${isOld ? "old" : ""}`} aria-label={`Machine ${machine.name}`}>
      <header className="machine-head">
        <h3>{machine.name}</h3>
        {machine.host !== machine.name && <span className="small muted machine-host">on {machine.host}</span>}
        <span className={`pill ${tone}`}>{word}</span>
      </header>
      {machine.notKept !== "" && !isOld && (
        <p className="notice hold small">
          {sentence(`started again it would forget the emergency stop: ${machine.notKept}`)}
        </p>
      )}
      {machine.rivalHost !== "" && (
        <p className="notice hold small">
          Another agent of this name is on {machine.rivalHost}, and is left out. End it, or start it with another name.
        </p>
      )}
      <FactList
        rows={[
          ["Robots", <Robots key="robots" machine={machine} />],
          ["Link", linkText(machine)],
          ["Clock", clockText(machine)],
          ["Health", `${healthText(machine)}, up ${age(machine.uptime)}`],
          ["Version", versionText(machine, own)],
        ]}
      />
    </li>
  );
}

const kMostShown = 24;

function Robots({ machine }: { machine: Machines_Machine }) {
  const { model } = useSession();
  const { robots } = machine;
  const others = othersText(machine);
  return (
    <span className="machine-robots">
      {robots.slice(0, kMostShown).map((id) => (
        <Button key={id} tone="link" aria-label={`Select robot ${id}`} onPress={() => model.select(selectRobots([id]))}>
          {id}
        </Button>
      ))}
      {robots.length > 1 && (
        <Button tone="link" onPress={() => model.select(selectRobots([...robots]))}>
          all {robots.length}
        </Button>
      )}
      {others}
    </span>
  );
}
