// The MDL text that a command made by mouse means.

export const kFormations = [
  // [[table formation_names]]
  "Line",
  "Line-Left",
  "Line-Right",
  "Wedge",
  "Wedge-Left",
  "Wedge-Right",
  "Diamond",
  "Column",
  "Sweep",
  "No-Formation",
  // [[end]]
] as const;
export type FormationName = (typeof kFormations)[number];

export const kTechniques = ["Traveling", "Traveling-Overwatch", "Bounding-Overwatch"] as const;
export type TechniqueName = (typeof kTechniques)[number];

const kRows = [
  // [[table task_rows]]
  {
    task: "MOVETO",
    label: "Move to",
    help: "Move the unit's centre there",
    takesFormation: true,
    takesHeading: true,
    takesTechnique: true,
    takesSpeed: true,
    takesSwath: false,
    place: "place",
  },
  {
    task: "OCCUPY",
    label: "Occupy",
    help: "Take up the formation there, hold it, then ask to proceed",
    takesFormation: true,
    takesHeading: true,
    takesTechnique: false,
    takesSpeed: false,
    takesSwath: false,
    place: "place",
  },
  {
    task: "SWEEPTO",
    label: "Sweep to",
    help: "Move there side by side",
    takesFormation: true,
    takesHeading: false,
    takesTechnique: true,
    takesSpeed: true,
    takesSwath: false,
    place: "place",
  },
  {
    task: "FOLLOW",
    label: "Follow",
    help: "Move along a line, from its first point to its last",
    takesFormation: true,
    takesHeading: false,
    takesTechnique: true,
    takesSpeed: true,
    takesSwath: false,
    place: "line",
  },
  {
    task: "TELEOPERATE",
    label: "Steer",
    help: "Steer the unit yourself, with the place as objective",
    takesFormation: true,
    takesHeading: false,
    takesTechnique: false,
    takesSpeed: true,
    takesSwath: false,
    place: "place",
  },
  {
    task: "RALLY",
    label: "Rally",
    help: "Each robot goes there by itself",
    takesFormation: false,
    takesHeading: false,
    takesTechnique: false,
    takesSpeed: true,
    takesSwath: false,
    place: "place",
  },
  {
    task: "VISIT",
    label: "Visit",
    help: "A robot goes to each of these places",
    takesFormation: false,
    takesHeading: false,
    takesTechnique: false,
    takesSpeed: true,
    takesSwath: false,
    place: "places",
  },
  {
    task: "SEARCH",
    label: "Search",
    help: "Its robots look at all of an area",
    takesFormation: false,
    takesHeading: false,
    takesTechnique: false,
    takesSpeed: true,
    takesSwath: true,
    place: "area",
  },
  {
    task: "PATROL",
    label: "Patrol",
    help: "Its robots go round these places, evenly spread",
    takesFormation: false,
    takesHeading: false,
    takesTechnique: false,
    takesSpeed: true,
    takesSwath: false,
    place: "places",
  },
  // [[end]]
] as const;

export type TaskName = (typeof kRows)[number]["task"];

export interface TaskInfo {
  readonly task: TaskName;
  readonly label: string;
  readonly help: string;
  readonly takesFormation: boolean;
  readonly takesHeading: boolean;
  readonly takesTechnique: boolean;
  readonly takesSpeed: boolean;
  readonly takesSwath: boolean;
  /** What stands behind the word: one place, several, or one of which a line or an area is wanted, by its name. */
  readonly place: "place" | "places" | "line" | "area";
}

/** What units can be told with the mouse, in the order of menus; `tools/tables` writes it from src/mlab/mission/tasks.h. */
export const kTasks: readonly TaskInfo[] = kRows;

export function taskInfo(task: TaskName): TaskInfo {
  return kTasks.find((t) => t.task === task) as TaskInfo;
}

/** Where to: a reference to a control measure, or a point [m, coordinates of the mission]. */
export type MdlPlace = { readonly reference: string } | { readonly x: number; readonly y: number };

export interface MouseCommand {
  readonly units: readonly string[];
  /** Robots by their numbers, in place of units: a unit for as long as the command lasts. */
  readonly robots: readonly number[];
  readonly task: TaskName;
  readonly place: MdlPlace;
  /** Of tasks that take several places: those behind the first one. */
  readonly more: readonly MdlPlace[];
  /** Empty: the clause is left out. */
  readonly formation: FormationName | "";
  readonly technique: TechniqueName | "";
  /** [m/s]; 0 and less: the robots' own, the clause is left out. */
  readonly speed: number;
  /** Degrees counter-clockwise from east; null: where it goes. */
  readonly heading: number | null;
  /** [m]; 0 and less: the usual one, the clause is left out. */
  readonly swath: number;
}

/** The line, or what is missing, as a sentence. Clauses that the task doesn't take are left out. */
export function mdlText(command: MouseCommand): { text: string } | { error: string } {
  const { robots } = command;
  if (command.units.length === 0 && robots.length === 0) return { error: "Select a unit or robots first." };
  const info = taskInfo(command.task);
  const places = [command.place, ...(info.place === "places" ? command.more : [])].map(placeText);
  if (places.includes(null)) return { error: "This place has no name that MDL could write." };
  const place = places.join(" ");
  if (info.place === "line" && !("reference" in command.place)) return { error: "Choose a line to follow." };
  if (info.place === "area" && !("reference" in command.place)) return { error: "Choose an area to search." };
  if (command.task === "PATROL" && places.length < 2)
    return { error: "Click the places to go round, one after the other." };
  const lines: string[] = [];
  if (robots.length > 0)
    lines.push(
      `${robots.length === 1 ? "ROBOT" : "ROBOTS"} ${robots.join(" ")} ${command.task} ${place}${clauses(command, info)}`,
    );
  for (const unit of command.units) {
    const name = mdlName(unit);
    if (name === null) return { error: `Unit ${unit} has no name that MDL could write.` };
    lines.push(`UNIT ${name} ${command.task} ${place}${clauses(command, info)}`);
  }
  return { text: lines.join(" AND ") };
}

function clauses(command: MouseCommand, info: TaskInfo): string {
  const parts: string[] = [];
  if (info.takesFormation && command.formation !== "") parts.push(`FORMATION ${command.formation}`);
  if (info.takesTechnique && command.technique !== "") parts.push(`TECHNIQUE ${command.technique}`);
  if (info.takesSpeed && command.speed > 0) parts.push(`SPEED ${mdlNumber(command.speed)}`);
  if (info.takesSwath && command.swath > 0) parts.push(`SWATH ${mdlNumber(command.swath)}`);
  if (info.takesHeading && command.heading !== null) parts.push(`HEADING ${mdlNumber(command.heading, 1)}`);
  return parts.map((p) => ` ${p}`).join("");
}

function placeText(place: MdlPlace): string | null {
  if ("reference" in place) return mdlName(place.reference);
  if (!Number.isFinite(place.x) || !Number.isFinite(place.y)) return null;
  return `${mdlNumber(place.x)} ${mdlNumber(place.y)}`;
}

/** A name as MDL and ODL write it, in quotes where it is no word; null where it can't be written (empty, or has a quote). */
export function mdlName(name: string): string | null {
  if (/^[A-Za-z][A-Za-z0-9_-]*$/.test(name)) return name;
  // biome-ignore lint/suspicious/noControlCharactersInRegex: a string ends with its line
  if (name === "" || /["\u0000-\u001f]/.test(name)) return null;
  return `"${name}"`;
}

/** A number as MDL and ODL write it: no sign before positive ones, no exponent. At most `decimals` behind the point. */
export function mdlNumber(value: number, decimals = 3): string {
  const text = value.toFixed(decimals);
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

/** Decimals that make sense on the map: a hand is not more precise than a pixel or so. */
export function decimalsFor(metresPerPixel: number): number {
  if (!(metresPerPixel > 0)) return 3;
  return Math.min(3, Math.max(0, Math.ceil(-Math.log10(metresPerPixel))));
}

/** The direction of a drag, whole steps of `step` degrees, 0 to 359. Angles count counter-clockwise from east. */
export function headingOfDrag(dx: number, dy: number, step: number): number {
  const degrees = (Math.atan2(dy, dx) * 180) / Math.PI;
  const rounded = Math.round(degrees / step) * step;
  return ((rounded % 360) + 360) % 360;
}
