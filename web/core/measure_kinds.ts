// The control measures that can be drawn: what each is called, what it is for, how it is given.

export type MeasureKind =
  | "assembly_area"
  | "attack_position"
  | "battle_position"
  | "objective"
  | "passage_point"
  | "start_point"
  | "axis"
  | "gap"
  | "boundary"
  | "line_of_departure"
  | "phase_line"
  | "wall"
  | "room"
  | "door"
  | "hallway"
  | "road";

/** How it is drawn: one click; a region's corners, or a drag for a circle; the points of a line; a rectangle. */
export type Shape = "point" | "region" | "line" | "hallway";

export interface KindInfo {
  readonly kind: MeasureKind;
  /** Measure.Kind of console.proto. */
  readonly wire: number;
  readonly keyword: string;
  readonly label: string;
  readonly purpose: string;
  readonly group: "Places" | "Lines" | "Buildings";
  readonly shape: Shape;
  readonly minPoints: number;
  readonly maxPoints: number;
  /** What its number means; empty: it has none. */
  readonly sizeLabel: "" | "diameter" | "width" | "height";
  readonly defaultSize: number;
}

const kMany = 10_000;

export const kKinds: readonly KindInfo[] = [
  {
    kind: "assembly_area",
    wire: 0,
    keyword: "AA",
    label: "Assembly area",
    purpose: "Where units gather and start",
    group: "Places",
    shape: "region",
    minPoints: 1,
    maxPoints: kMany,
    sizeLabel: "diameter",
    defaultSize: 50,
  },
  {
    kind: "passage_point",
    wire: 4,
    keyword: "PP",
    label: "Passage point",
    purpose: "A point on the way",
    group: "Places",
    shape: "point",
    minPoints: 1,
    maxPoints: 1,
    sizeLabel: "diameter",
    defaultSize: 10,
  },
  {
    kind: "attack_position",
    wire: 1,
    keyword: "ATK",
    label: "Attack position",
    purpose: "The last place before the attack",
    group: "Places",
    shape: "region",
    minPoints: 1,
    maxPoints: kMany,
    sizeLabel: "diameter",
    defaultSize: 50,
  },
  {
    kind: "battle_position",
    wire: 2,
    keyword: "BP",
    label: "Battle position",
    purpose: "A place to hold",
    group: "Places",
    shape: "region",
    minPoints: 1,
    maxPoints: kMany,
    sizeLabel: "diameter",
    defaultSize: 50,
  },
  {
    kind: "objective",
    wire: 3,
    keyword: "OBJ",
    label: "Objective",
    purpose: "What the mission is to reach",
    group: "Places",
    shape: "region",
    minPoints: 1,
    maxPoints: kMany,
    sizeLabel: "diameter",
    defaultSize: 50,
  },
  {
    kind: "start_point",
    wire: 5,
    keyword: "SP",
    label: "Start point",
    purpose: "Where a robot starts",
    group: "Places",
    shape: "point",
    minPoints: 1,
    maxPoints: 1,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "axis",
    wire: 6,
    keyword: "AXIS",
    label: "Axis of advance",
    purpose: "A line to follow, in its direction",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "width",
    defaultSize: 100,
  },
  {
    kind: "gap",
    wire: 7,
    keyword: "GAP",
    label: "Gap",
    purpose: "A way through; opens nothing",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: 2,
    sizeLabel: "width",
    defaultSize: 40,
  },
  {
    kind: "boundary",
    wire: 8,
    keyword: "BOUNDARY",
    label: "Boundary",
    purpose: "Limit between units, or a closed zone",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "phase_line",
    wire: 10,
    keyword: "PL",
    label: "Phase line",
    purpose: "Its crossing is told, or waited at",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "line_of_departure",
    wire: 9,
    keyword: "LDLC",
    label: "Line of departure",
    purpose: "Line of departure, line of contact",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "road",
    wire: 15,
    keyword: "ROAD",
    label: "Road",
    purpose: "A road, to follow and to perceive",
    group: "Lines",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "width",
    defaultSize: 10,
  },
  {
    kind: "wall",
    wire: 11,
    keyword: "WALL",
    label: "Wall",
    purpose: "Solid: stops robots, hides what is behind",
    group: "Buildings",
    shape: "line",
    minPoints: 2,
    maxPoints: kMany,
    sizeLabel: "height",
    defaultSize: 1,
  },
  {
    kind: "room",
    wire: 12,
    keyword: "ROOM",
    label: "Room",
    purpose: "Robots know that they are inside",
    group: "Buildings",
    shape: "region",
    minPoints: 3,
    maxPoints: kMany,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "door",
    wire: 13,
    keyword: "DOOR",
    label: "Door",
    purpose: "Robots see it; opens no wall",
    group: "Buildings",
    shape: "line",
    minPoints: 2,
    maxPoints: 2,
    sizeLabel: "",
    defaultSize: 0,
  },
  {
    kind: "hallway",
    wire: 14,
    keyword: "HALLWAY",
    label: "Hallway",
    purpose: "Robots know that they are inside, and its direction",
    group: "Buildings",
    shape: "hallway",
    minPoints: 2,
    maxPoints: 2,
    sizeLabel: "width",
    defaultSize: 2,
  },
];

const kByKind = new Map(kKinds.map((k) => [k.kind, k]));
const kByWire = new Map(kKinds.map((k) => [k.wire, k]));

export function kindInfo(kind: MeasureKind): KindInfo {
  return kByKind.get(kind) as KindInfo;
}

/** undefined: a kind of a newer server. */
export function kindOfWire(wire: number): KindInfo | undefined {
  return kByWire.get(wire);
}

export function keywordOf(kind: MeasureKind): string {
  return kindInfo(kind).keyword;
}

/** Those that FOLLOW takes. */
export const kLineKinds: ReadonlySet<MeasureKind> = new Set<MeasureKind>([
  "axis",
  "boundary",
  "door",
  "gap",
  "hallway",
  "line_of_departure",
  "phase_line",
  "road",
  "room",
  "wall",
]);
