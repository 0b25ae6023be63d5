// What can be plotted: a quantity or a port, of a robot or of a unit.

export type QuantityName =
  | "port"
  | "distance_to_goal"
  | "formation_error"
  | "speed"
  | "distance_driven"
  | "contacts"
  | "nearest_obstacle"
  | "heading";

/** One line of a plot. Exactly one of robot (not 0) and unit is given; `port` only with the quantity "port". */
export interface SeriesSpec {
  readonly quantity: QuantityName;
  readonly robot: number;
  readonly unit: string;
  readonly port: string;
}

export interface QuantityInfo {
  readonly name: QuantityName;
  /** Series.Quantity of console_orders.proto. */
  readonly wire: number;
  readonly label: string;
  /** As shown on the axis. */
  readonly unit: string;
  readonly help: string;
  /** From what is sent to what is shown. */
  readonly factor: number;
}

/** All quantities but ports, in the order in which they are offered. */
export const kQuantities: readonly QuantityInfo[] = [
  {
    name: "distance_to_goal",
    wire: 1,
    label: "Distance to goal",
    unit: "m",
    help: "How far it is to the goal of the present command",
    factor: 1,
  },
  {
    name: "formation_error",
    wire: 2,
    label: "Formation error",
    unit: "m",
    help: "Distance from the station in the formation; of a unit the mean",
    factor: 1,
  },
  { name: "speed", wire: 3, label: "Speed", unit: "m/s", help: "Speed over ground; of a unit the mean", factor: 1 },
  {
    name: "distance_driven",
    wire: 4,
    label: "Distance driven",
    unit: "m",
    help: "Length of the path since the start",
    factor: 1,
  },
  { name: "contacts", wire: 5, label: "Contacts", unit: "", help: "How often it has touched something", factor: 1 },
  {
    name: "nearest_obstacle",
    wire: 6,
    label: "Nearest obstacle",
    unit: "m",
    help: "Room between the robot and what is nearest, edge to edge",
    factor: 1,
  },
  {
    name: "heading",
    wire: 7,
    label: "Heading",
    unit: "deg",
    help: "Counter-clockwise from east",
    factor: 180 / Math.PI,
  },
];

const kByName = new Map(kQuantities.map((q) => [q.name, q]));

export function quantityInfo(name: QuantityName): QuantityInfo | undefined {
  return kByName.get(name);
}

/** Names a series for all time: equal for equal series, also after a reload. */
export function seriesKey(s: SeriesSpec): string {
  const who = s.robot !== 0 ? `r${s.robot}` : `u:${s.unit}`;
  return s.quantity === "port" ? `${who}/port/${s.port}` : `${who}/${s.quantity}`;
}

/** Who the line belongs to, as people write it. */
export function whoLabel(s: SeriesSpec): string {
  return s.robot !== 0 ? `Robot ${s.robot}` : s.unit;
}

/** What is plotted, without who. */
export function subjectLabel(s: SeriesSpec): string {
  return s.quantity === "port" ? s.port : (kByName.get(s.quantity)?.label ?? s.quantity);
}

export function seriesLabel(s: SeriesSpec): string {
  return `${whoLabel(s)}: ${subjectLabel(s)}`;
}

/** Reads what was kept from an earlier visit. Whatever is not a series is left out. */
export function seriesFromJson(value: unknown): SeriesSpec[] {
  if (!Array.isArray(value)) return [];
  const seen = new Set<string>();
  const result: SeriesSpec[] = [];
  for (const each of value) {
    const s = oneFromJson(each);
    if (!s || seen.has(seriesKey(s))) continue;
    seen.add(seriesKey(s));
    result.push(s);
  }
  return result;
}

function oneFromJson(value: unknown): SeriesSpec | null {
  if (typeof value !== "object" || value === null) return null;
  const { quantity, robot, unit, port } = value as Record<string, unknown>;
  if (quantity !== "port" && !kByName.has(quantity as QuantityName)) return null;
  const isRobot = typeof robot === "number" && Number.isInteger(robot) && robot > 0;
  if (!isRobot && (typeof unit !== "string" || unit === "")) return null;
  if (quantity === "port" && (!isRobot || typeof port !== "string" || port === "")) return null;
  return {
    quantity: quantity as QuantityName,
    robot: isRobot ? robot : 0,
    unit: isRobot ? "" : (unit as string),
    port: quantity === "port" ? (port as string) : "",
  };
}
