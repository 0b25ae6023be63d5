// What is written beside a control measure.
import { type Measure, Measure_Kind } from "../protocol.ts";
import { kindOfWire } from "../tables/measures.ts";
import type { Palette } from "./palette.ts";

const K = Measure_Kind;

/** Empty: nothing is written. */
export function labelOf(measure: Measure, military: boolean): string {
  if (!measure.showsLabel || !measure.name) return "";
  return military ? militaryLabel(measure) : plainLabel(measure);
}

function plainLabel({ kind, name }: Measure): string {
  const said = kindOfWire(kind)?.said;
  return said ? `${said} ${name}` : name;
}

/** A letter code and the name in capitals; a name that begins with the code isn't told twice. */
function militaryLabel({ kind, name, zone }: Measure): string {
  const code = kind === K.BOUNDARY && zone === "no-fly" ? "ROZ" : (kindOfWire(kind)?.code ?? "");
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
  return military ? palette.ink : palette[kindOfWire(measure.kind)?.color ?? "softInk"];
}
