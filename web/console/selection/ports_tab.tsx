import { useCallback, useMemo, useState, useSyncExternalStore } from "react";
import { portText } from "../../core/port_values.ts";
import { Search, Segments } from "../../ui/controls/controls.tsx";
import { usePart, useSession } from "../session/session.ts";
import { portGroups, type RoleFilter, spacedName } from "./ports.ts";
import { usePorts } from "./use_watched.ts";

/** Every port of the robot's program, live. */
export function PortsTab({ id }: { id: number }) {
  const roster = usePart("roster");
  const [query, setQuery] = useState("");
  const [role, setRole] = useState<RoleFilter>("all");
  usePorts("ports", true);
  const ports = roster.portsOf(id);
  const groups = useMemo(() => portGroups(ports, query, role), [ports, query, role]);
  if (ports.length === 0) return <p className="empty">This robot has no program.</p>;
  return (
    <div className="rows tab-body">
      <Search label="Find a port" value={query} onChange={setQuery} />
      <Segments
        label="Which ports"
        value={role}
        onChange={setRole}
        choices={[
          ["all", "All"],
          ["outputs", "Outputs"],
          ["parameters", "Parameters"],
        ]}
      />
      {groups.map((group) => (
        <section key={group.node} aria-label={group.node || "Program"}>
          <h3 className="mono port-node">{group.node || "program"}</h3>
          <dl className="facts">
            {group.rows.map((row) => (
              <div key={row.index} title={row.port.help}>
                <dt>{spacedName(row.name)}</dt>
                <dd className="mono">
                  <PortValue id={id} index={row.index} />
                </dd>
              </div>
            ))}
          </dl>
        </section>
      ))}
      {groups.length === 0 && <p className="empty small">No port is called that.</p>}
    </div>
  );
}

/** Drawn anew only when its own text changes. */
export function PortValue({ id, index }: { id: number; index: number }) {
  return usePortText(id, index) || "–";
}

export function usePortText(id: number, index: number): string {
  const { model } = useSession();
  const subscribe = useCallback((listener: () => void) => model.subscribe("details", listener), [model]);
  return useSyncExternalStore(subscribe, () => portText(model.get("details").get(id), index));
}
