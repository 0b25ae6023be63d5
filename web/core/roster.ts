// Who there is, found by id and by name.
import { kNone, type Port, type Roster, type Roster_Robot, type Roster_Unit } from "./protocol.ts";

/** A Roster with its indexes; never changed, a new one takes its place. */
export class RosterIndex {
  readonly robots: readonly Roster_Robot[];
  readonly units: readonly Roster_Unit[];
  private readonly byId = new Map<number, Roster_Robot>();
  private readonly byName = new Map<string, number>();
  private readonly members: number[][];

  constructor(private readonly roster: Roster | null) {
    this.robots = roster?.robots ?? [];
    this.units = roster?.units ?? [];
    for (const robot of this.robots) this.byId.set(robot.id, robot);
    this.members = this.units.map((unit) => [...unit.members]);
    this.units.forEach((unit, index) => {
      this.byName.set(unit.name.toLowerCase(), index);
      this.addToParents(index);
    });
  }

  robot(id: number): Roster_Robot | undefined {
    return this.byId.get(id);
  }

  /** The one name of a robot for people, everywhere: `Robot 3`. Messages of a run call it `robot 3`. */
  nameOf(id: number): string {
    return `Robot ${id}`;
  }

  /** Names are told apart without case, as the mission language does. */
  unit(name: string): Roster_Unit | undefined {
    const index = this.byName.get(name.toLowerCase());
    return index === undefined ? undefined : this.units[index];
  }

  /** The ids of a unit's robots, those of the units in it included. */
  robotsOf(name: string): readonly number[] {
    const index = this.byName.get(name.toLowerCase());
    return index === undefined ? [] : this.members[index]!;
  }

  /** The ports of the robot's program, in the order of RobotDetail.ports. */
  portsOf(id: number): readonly Port[] {
    const program = this.byId.get(id)?.program ?? kNone;
    return this.roster?.programs[program]?.ports ?? [];
  }

  programNames(): string[] {
    return (this.roster?.programs ?? []).map(({ name }) => name);
  }

  programOf(id: number): string {
    return this.roster?.programs[this.byId.get(id)?.program ?? kNone]?.name ?? "";
  }

  private addToParents(index: number): void {
    let parent = this.units[index]!.parent;
    for (let depth = 0; parent >= 0 && parent < this.units.length && depth < this.units.length; ++depth) {
      const known = new Set(this.members[parent]!);
      for (const id of this.units[index]!.members) if (!known.has(id)) this.members[parent]!.push(id);
      parent = this.units[parent]!.parent;
    }
  }
}
