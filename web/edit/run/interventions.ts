// What a person makes a robot do against its program: values that are held, states that it is sent to.
import type { HeldValues_Held as Held, RobotDetail } from "../../core/protocol.ts";

/** What holds the robot's port; nodes that compute the same are held together. */
export function heldAt(held: readonly Held[], robot: number, port: string): Held | undefined {
  return held.find((one) => one.robot === robot && (one.port === port || one.also.includes(port)));
}

/** Paths of all ports of the robot that show a held value. */
export function heldPorts(held: readonly Held[], robot: number): ReadonlySet<string> {
  return new Set(held.filter((one) => one.robot === robot).flatMap(({ port, also }) => [port, ...also]));
}

/** The state in which a sequence of the robot is; empty: not known. `sequence`: its path. */
export function stateOf(detail: Pick<RobotDetail, "states"> | undefined, sequence: string): string {
  const before = `${sequence}.`;
  const found = detail?.states.find((state) => state.startsWith(before) && !state.slice(before.length).includes("."));
  return found?.slice(before.length) ?? "";
}
