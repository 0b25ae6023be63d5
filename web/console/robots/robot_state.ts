// How a robot is, in a word, from the flags of its record.
import type { Model } from "../../core/model.ts";
import type { Status } from "../../core/protocol.ts";
import { Flag, Life, type RobotTable } from "../../core/robots.ts";

export interface RobotState {
  word: string;
  tone: "" | "go" | "hold" | "danger" | "accent";
}

export function robotState(flags: number): RobotState {
  const life = flags & 7;
  if (life === Life.FAULTED) return { word: "Faulted", tone: "danger" };
  if (flags & Flag.LOST) return { word: "Lost", tone: "danger" };
  if (flags & Flag.CONTACT) return { word: "In contact", tone: "danger" };
  if (flags & Flag.STUCK) return { word: "Stuck", tone: "hold" };
  if (flags & Flag.TELEOPERATED) return { word: "Steered", tone: "accent" };
  if (life === Life.STOPPED) return { word: "Stopped", tone: "" };
  if (life === Life.PARKED) return { word: "Parked", tone: "" };
  if (flags & Flag.DONE) return { word: "Done", tone: "go" };
  if (life === Life.RUNNING) return { word: "Running", tone: "go" };
  return { word: "Not started", tone: "" };
}

/** Of a robot whose machine is not heard: how old what is shown of it is. */
export function silenceOf(status: Status | null | undefined, robot: number): (RobotState & { title: string }) | null {
  const machine = status?.silentMachines.find(({ robots }) => robots.includes(robot));
  if (!machine) return null;
  const word = `Silent ${Math.floor(machine.silent)} s`;
  return { word, tone: "", title: `${word}: nothing is heard of machine ${machine.name}, what is shown is as old` };
}

/** What is shown as a robot's state: how it is, or how old that is. */
export function shownState(model: Pick<Model, "robots" | "get">, robot: number): RobotState & { title?: string } {
  const row = model.robots.rowOf(robot);
  return silenceOf(model.get("status"), robot) ?? robotState(row < 0 ? 0 : model.robots.flags(row));
}

/** Of these robots those that stand because of a fault. */
export function faulted(table: RobotTable, robots: readonly number[]): readonly number[] {
  return robots.filter((id) => {
    const row = table.rowOf(id);
    return row >= 0 && (table.flags(row) & 7) === Life.FAULTED;
  });
}
