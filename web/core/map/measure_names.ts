// What is written beside a control measure.
import { type Measure, Measure_Kind } from "../protocol.ts";
import type { Palette } from "./palette.ts";

const K = Measure_Kind;

/** The kinds by their words in the overlay language and by their names for people. */
export const kKinds: Readonly<Record<Measure_Kind, { readonly word: string; readonly name: string }>> = {
  [K.ASSEMBLY_AREA]: { word: "AA", name: "Assembly area" },
  [K.ATTACK_POSITION]: { word: "ATK", name: "Attack position" },
  [K.BATTLE_POSITION]: { word: "BP", name: "Battle position" },
  [K.OBJECTIVE]: { word: "OBJ", name: "Objective" },
  [K.PASSAGE_POINT]: { word: "PP", name: "Passage point" },
  [K.START_POINT]: { word: "SP", name: "Start point" },
  [K.AXIS]: { word: "AXIS", name: "Axis of advance" },
  [K.GAP]: { word: "GAP", name: "Gap" },
  [K.BOUNDARY]: { word: "BOUNDARY", name: "Boundary" },
  [K.LINE_OF_DEPARTURE]: { word: "LDLC", name: "Line of departure / line of contact" },
  [K.PHASE_LINE]: { word: "PL", name: "Phase line" },
  [K.WALL]: { word: "WALL", name: "Wall" },
  [K.ROOM]: { word: "ROOM", name: "Room" },
  [K.DOOR]: { word: "DOOR", name: "Door" },
  [K.HALLWAY]: { word: "HALLWAY", name: "Hallway" },
  [K.ROAD]: { word: "ROAD", name: "Road" },
};

/** Empty: nothing is written. */
export function labelOf(measure: Measure, military: boolean): string {
  if (!measure.showsLabel || !measure.name) return "";
  return military ? militaryLabel(measure) : plainLabel(measure);
}

function plainLabel({ kind, name }: Measure): string {
  switch (kind) {
    case K.AXIS:
      return `Axis ${name}`;
    case K.LINE_OF_DEPARTURE:
      return `LD/LC ${name}`;
    case K.PHASE_LINE:
      return `PL ${name}`;
    case K.START_POINT:
      return `SP ${name}`;
    default:
      return name;
  }
}

/** A letter code and the name in capitals; a name that begins with the code isn't told twice. */
function militaryLabel({ kind, name, zone }: Measure): string {
  const codes: Partial<Record<Measure_Kind, string>> = {
    [K.ASSEMBLY_AREA]: "AA",
    [K.ATTACK_POSITION]: "ATK",
    [K.BATTLE_POSITION]: "BP",
    [K.OBJECTIVE]: "OBJ",
    [K.PHASE_LINE]: "PL",
    [K.LINE_OF_DEPARTURE]: "LD/LC",
  };
  const code = kind === K.BOUNDARY && zone === "no-fly" ? "ROZ" : (codes[kind] ?? "");
  const rest = name.toUpperCase();
  if (!code) return rest;
  return rest.startsWith(code) && rest.length > code.length && !/[A-Z]/.test(rest[code.length]!)
    ? `${code} ${rest.slice(code.length).replace(/^[-_ ]/, "")}`
    : `${code} ${rest}`;
}

export function colorOf(measure: Measure, palette: Palette, military: boolean): string {
  if (measure.kind === K.BOUNDARY) {
    if (measure.zone === "weather") return palette.weather;
    if (measure.zone === "no-fly") return palette.noFly;
    if (measure.zone === "no-communication") return palette.noCommunication;
    return military ? palette.ink : palette.boundary;
  }
  if (military) return palette.ink;
  switch (measure.kind) {
    case K.ASSEMBLY_AREA:
      return palette.assembly;
    case K.ATTACK_POSITION:
      return palette.attack;
    case K.BATTLE_POSITION:
      return palette.battle;
    case K.OBJECTIVE:
      return palette.objective;
    case K.PASSAGE_POINT:
    case K.START_POINT:
      return palette.passage;
    case K.AXIS:
      return palette.axis;
    case K.LINE_OF_DEPARTURE:
    case K.PHASE_LINE:
      return palette.line;
    case K.GAP:
      return palette.gap;
    case K.WALL:
    case K.DOOR:
      return palette.wall;
    default:
      return palette.softInk;
  }
}
