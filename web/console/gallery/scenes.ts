// Made-up sessions for the gallery and the benchmark: every feature once, the historic missions, ten thousand robots.
import { create, type MessageInitShape } from "@bufbuild/protobuf";
import {
  type Frame,
  FrameSchema,
  Measure_Kind as K,
  type RosterSchema,
  type SceneSchema,
  WorldObject_Style,
} from "../../core/protocol.ts";
import { kRecordBytes, writeRecord } from "../../core/robots.ts";

type SceneInit = MessageInitShape<typeof SceneSchema>;
type RosterInit = MessageInitShape<typeof RosterSchema>;
type MeasureInit = NonNullable<SceneInit["measures"]>[number];

export interface Session {
  readonly scene: SceneInit;
  readonly roster: RosterInit;
  readonly robots: readonly PlacedRobot[];
}

export interface PlacedRobot {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly heading: number;
  readonly flags: number;
}

const kPalette = ["#1f5fd6", "#c92a2a", "#2b8a3e", "#e67700", "#7048e8", "#0b7285", "#a61e4d", "#5c940d"];

function measure(kind: K, name: string, points: number[], more: Partial<MeasureInit> = {}): MeasureInit {
  const pairs = [];
  for (let i = 0; i + 1 < points.length; i += 2) pairs.push({ x: points[i]!, y: points[i + 1]! });
  return { kind, name, showsLabel: true, points: pairs, document: "gallery.odl", ...more } as MeasureInit;
}

function obstacles(text: string): NonNullable<SceneInit["obstacles"]> {
  return text
    .trim()
    .split(/\s*;\s*/)
    .map((one) => one.split(/\s+/).map(Number))
    .map(([x, y, radius]) => ({ x, y, radius, height: 3, document: "gallery.odl" }));
}

function team(count: number, unit: string, color: (i: number) => string, first = 1): RosterInit["robots"] {
  return Array.from({ length: count }, (_, i) => ({
    id: first + i,
    type: "robot",
    color: color(i),
    radius: 0.5,
    length: 1.6,
    unit,
    program: 0xffffffff,
  }));
}

/** The lane of the report's demonstration. */
export function demoC(): Session {
  return {
    scene: {
      revision: 1n,
      scenario: "Demo-C",
      width: 1100,
      height: 800,
      measures: [
        measure(K.BOUNDARY, "North", [20, 700, 1080, 700]),
        measure(K.BOUNDARY, "South", [20, 60, 1080, 60]),
        measure(K.ASSEMBLY_AREA, "AA1", [70, 110, 210, 110, 210, 230, 70, 230]),
        measure(K.ATTACK_POSITION, "AP1", [150, 400], { size: 80 }),
        measure(K.PASSAGE_POINT, "Charlie", [300, 420], { size: 10 }),
        measure(K.LINE_OF_DEPARTURE, "Echo", [380, 690, 380, 70]),
        measure(K.GAP, "Delta", [350, 420, 410, 420], { size: 120 }),
        measure(K.PASSAGE_POINT, "Delta1", [470, 420], { size: 10 }),
        measure(K.AXIS, "Golf", [470, 420, 700, 420], { size: 160 }),
        measure(K.PASSAGE_POINT, "Gamma1", [690, 420], { size: 10 }),
        measure(K.PHASE_LINE, "Gamma", [690, 690, 690, 70]),
        measure(K.BATTLE_POSITION, "BP1", [800, 560], { size: 60 }),
        measure(K.BATTLE_POSITION, "BP2", [810, 270], { size: 60 }),
        measure(K.OBJECTIVE, "Tango", [980, 420], { size: 140 }),
      ],
      obstacles: obstacles(
        "250 560 8; 290 300 10; 380 560 12; 540 560 9; 600 250 12; 700 600 10; 690 230 8; 900 640 12; 930 200 10; 520 330 9",
      ),
    },
    roster: { robots: team(4, "scouts", (i) => (i < 2 ? "#1f5fd6" : "#c92a2a")), units: [unitOf("scouts", 4)] },
    robots: [
      { id: 1, x: 430, y: 470, heading: 0.1, flags: 1 },
      { id: 2, x: 430, y: 436, heading: -0.1, flags: 1 | 0x20 },
      { id: 3, x: 428, y: 402, heading: 0.2, flags: 1 | 0x10 },
      { id: 4, x: 424, y: 366, heading: 0.05, flags: 1 | 0x08 },
    ],
  };
}

function unitOf(name: string, count: number, first = 1) {
  return { name, members: Array.from({ length: count }, (_, i) => first + i), parent: -1 };
}

const kStroll = { route: [{ x: 420, y: 300 }], speed: 1 };

/** Each kind of control measure, each form of it, beside each other. */
export function everything(): Session {
  const zone = (name: string, x: number, kind: string) =>
    measure(K.BOUNDARY, name, [x, 30, x + 110, 30, x + 120, 120, x + 10, 125, x, 30], { zone: kind });
  return {
    scene: {
      revision: 2n,
      scenario: "Gallery",
      width: 1000,
      height: 640,
      measures: [
        measure(K.ASSEMBLY_AREA, "AA1", [40, 520, 160, 520, 175, 600, 60, 610]),
        measure(K.ASSEMBLY_AREA, "Bravo", [235, 565], { size: 70 }),
        measure(K.ATTACK_POSITION, "Alpha", [330, 565], { size: 60 }),
        measure(K.ATTACK_POSITION, "Zulu", [400, 530, 470, 540, 460, 600, 410, 605]),
        measure(K.BATTLE_POSITION, "BP1", [530, 565], { size: 60 }),
        measure(K.BATTLE_POSITION, "North", [600, 530, 670, 540, 690, 590, 620, 610]),
        measure(K.OBJECTIVE, "Tango", [770, 565], { size: 90 }),
        measure(K.OBJECTIVE, "Sierra", [850, 525, 960, 540, 940, 610, 860, 600]),
        measure(K.MINEFIELD, "Juliet", [740, 290, 840, 285, 850, 350, 750, 360]),
        measure(K.LANDING_ZONE, "Eagle", [880, 320, 985, 310, 990, 395, 905, 400]),
        measure(K.PASSAGE_POINT, "Charlie", [60, 450], { size: 12 }),
        measure(K.PASSAGE_POINT, "Delta1", [90, 450], { size: 12 }),
        measure(K.START_POINT, "Home", [160, 430]),
        measure(K.AXIS, "Golf", [220, 440, 320, 480, 420, 420], { size: 46 }),
        measure(K.AXIS, "Lima", [470, 470, 600, 430], { size: 30 }),
        measure(K.GAP, "Foxtrot", [660, 450, 700, 450], { size: 60 }),
        measure(K.BOUNDARY, "East", [760, 490, 800, 440, 880, 450, 960, 410]),
        measure(K.BOUNDARY, "Depot", [940, 470]),
        measure(K.LINE_OF_DEPARTURE, "Echo", [50, 380, 400, 340]),
        measure(K.PHASE_LINE, "Gamma", [450, 390, 560, 330, 700, 380]),
        zone("WeatherZone1", 30, "weather"),
        zone("NoFlyZone1", 180, "no-fly"),
        zone("NoCommZone1", 330, "no-communication"),
        measure(K.ROOM, "Room 12", [500, 40, 600, 40, 600, 130, 500, 130]),
        measure(K.ROOM, "Room 13", [600, 40, 700, 40, 700, 130, 600, 130]),
        measure(K.HALLWAY, "Hall", [500, 130, 700, 130, 700, 160, 500, 160], {
          centerline: [
            { x: 505, y: 145 },
            { x: 695, y: 145 },
          ],
          size: 30,
        }),
        measure(K.WALL, "", [500, 40, 600, 40, 600, 130, 500, 130, 500, 40]),
        measure(K.WALL, "", [600, 40, 700, 40, 700, 130, 600, 130]),
        measure(K.WALL, "Outer", [500, 160, 700, 160]),
        measure(K.DOOR, "D12", [540, 130, 562, 130]),
        measure(K.DOOR, "D13", [640, 130, 662, 130]),
        measure(K.ROAD, "Road 7", [740, 30, 820, 80, 830, 160, 960, 200], { size: 16 }),
        measure(K.ROAD, "Track", [760, 200, 850, 260, 960, 260], { size: 4 }),
      ],
      obstacles: obstacles("60 290 12; 100 270 6; 130 300 9; 160 270 4; 100 310 5"),
      objects: [
        { x: 230, y: 285, diameter: 14, style: WorldObject_Style.FIXED, color: "forest green", id: 1 },
        { x: 260, y: 285, diameter: 10, style: WorldObject_Style.MOVABLE, color: "orange", id: 2 },
        { x: 295, y: 285, diameter: 22, style: WorldObject_Style.CONTAINER, color: "green", id: 3 },
        { x: 320, y: 285, diameter: 6, style: WorldObject_Style.MOVABLE, color: "black", id: 4 },
        { x: 340, y: 285, diameter: 6, style: WorldObject_Style.MOVABLE, color: "white", id: 5 },
        { x: 370, y: 275, diameter: 8, style: WorldObject_Style.MOVABLE, color: "purple", id: 6, ...kStroll },
      ].map((object) => ({ ...object, document: "gallery.odl" })),
    },
    roster: { robots: team(8, "alpha", (i) => kPalette[i]!), units: [unitOf("alpha", 8)] },
    robots: [1, 2, 3, 4, 9, 17, 33, 129].map((flags, i) => ({
      id: i + 1,
      x: 420 + i * 40,
      y: 250,
      heading: (i / 8) * 2 * Math.PI,
      flags: flags > 8 ? (flags & ~7) | 1 : flags,
    })),
  };
}

/** A background picture: a tree in the north of a meadow. */
const kPlan = `data:image/svg+xml,${encodeURIComponent(
  '<svg xmlns="http://www.w3.org/2000/svg" width="150" height="300"><rect width="150" height="300" fill="#cfe3bd"/><circle cx="75" cy="60" r="45" fill="#5d8a46"/></svg>',
)}`;

/** Rooms, walls and one robot: ten metres across. */
export function robotLab(): Session {
  return {
    scene: {
      revision: 3n,
      scenario: "Robot laboratory",
      width: 15,
      height: 10,
      measures: [
        measure(K.BOUNDARY, "MARC 362", [0.3, 0.5, 11, 0.5, 11, 6.6, 2, 6.6, 2, 3.9, 0.3, 3.9, 0.3, 0.5]),
        measure(K.GAP, "DoorWay", [10.8, 2.3, 11.2, 2.3], { size: 1.5 }),
        measure(K.PASSAGE_POINT, "NearDoor", [9.3, 2.9], { size: 0.4 }),
        measure(K.PASSAGE_POINT, "Middle", [5.3, 3.5], { size: 0.4 }),
        measure(K.START_POINT, "StartPlace", [3.7, 4.8]),
        measure(K.WALL, "Desk", [6, 6.6, 6, 5, 8, 5]),
      ],
      obstacles: obstacles("7 2 0.3; 4.4 2.2 0.45"),
      picture: { url: kPlan, x: 11.5, y: 1, width: 3, height: 6 },
    },
    roster: { robots: team(1, "stimpy", () => "#1f5fd6"), units: [unitOf("stimpy", 1)] },
    robots: [{ id: 1, x: 6.2, y: 3.3, heading: -0.3, flags: 1 }],
  };
}

/** Many robots on patrol round their places. */
export function crowd(count: number): Session {
  const robots = Array.from({ length: count }, (_, i) => place(i, 0));
  return {
    scene: {
      ...demoC().scene,
      revision: 4n,
      width: 1100,
      height: 800,
    },
    roster: {
      robots: robots.map(({ id }) => ({
        id,
        type: "robot",
        color: kPalette[id % kPalette.length]!,
        radius: 0.2,
        length: 0.6,
        unit: `unit-${id % 100}`,
        program: 0xffffffff,
      })),
    },
    robots,
  };
}

/** Where robot `i` of a crowd is after so much time. */
export function place(i: number, time: number): PlacedRobot {
  const phase = time * 0.4 + i * 1.7;
  const x = ((i * 7919) % 1081) + 10 + 8 * Math.cos(phase);
  const y = ((i * 104729) % 777) + 10 + 8 * Math.sin(phase);
  return { id: i + 1, x, y, heading: phase + Math.PI / 2, flags: 1 };
}

export function frameOf(robots: readonly PlacedRobot[], number: number, time: number): Frame {
  const bytes = new Uint8Array(robots.length * kRecordBytes);
  const view = new DataView(bytes.buffer);
  for (let row = 0; row < robots.length; ++row) writeRecord(view, row, robots[row]!);
  return create(FrameSchema, {
    number: BigInt(number),
    time,
    cycle: BigInt(Math.round(time * 10)),
    robots: bytes,
  });
}
