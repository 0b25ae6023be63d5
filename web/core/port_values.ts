// Values of a program's ports in a RobotDetail: of all, or of those alone that were wished.
import type { RobotDetail } from "./protocol.ts";

/** Where the lists of the detail have the port of this index into Roster.Program.ports; -1: they have not. */
export function placeOfPort(
  detail: Pick<RobotDetail, "hasSomePorts" | "portIndices" | "ports">,
  index: number,
): number {
  if (index < 0) return -1;
  if (!detail.hasSomePorts) return index < detail.ports.length ? index : -1;
  const { portIndices } = detail;
  let low = 0;
  let high = portIndices.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (portIndices[middle]! < index) low = middle + 1;
    else high = middle;
  }
  return portIndices[low] === index ? low : -1;
}

/** As a person reads it; empty: not known. */
export function portText(detail: RobotDetail | undefined, index: number): string {
  return detail ? (detail.ports[placeOfPort(detail, index)] ?? "") : "";
}
