// The ports of a robot's program, as a list that can be searched and folded.
import { type Port, Port_Role } from "../../core/protocol.ts";

export interface PortRow {
  index: number; // into Program.ports and RobotDetail.ports
  name: string; // last part of the path
  port: Port;
}

export interface PortGroup {
  node: string; // all but the last part of the path; empty: of the program itself
  rows: PortRow[];
}

export type RoleFilter = "all" | "parameters" | "outputs";

/** Groups in the order in which their first port stands in the program. Words of the query may match in any order. */
export function portGroups(ports: readonly Port[], query: string, role: RoleFilter): PortGroup[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  const groups = new Map<string, PortGroup>();
  ports.forEach((port, index) => {
    if (role === "parameters" && port.role !== Port_Role.PARAMETER) return;
    if (role === "outputs" && port.role !== Port_Role.OUTPUT) return;
    const searched = `${port.path} ${port.type} ${port.help}`.toLowerCase();
    if (!words.every((word) => searched.includes(word))) return;
    const { node, name } = splitPath(port.path);
    const group = groups.get(node) ?? { node, rows: [] };
    group.rows.push({ index, name, port });
    groups.set(node, group);
  });
  return [...groups.values()];
}

export function splitPath(path: string): { node: string; name: string } {
  const at = Math.max(path.lastIndexOf("."), path.lastIndexOf("/"));
  return at < 0 ? { node: "", name: path } : { node: path.slice(0, at), name: path.slice(at + 1) };
}

/** `base_gain` is read more easily as `base gain`. */
export function spacedName(name: string): string {
  return name.replaceAll("_", " ");
}
