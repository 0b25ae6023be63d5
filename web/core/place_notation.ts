// How a place is written, for people: in metres of the map, or as one on the Earth, in the notations of src/mlab/geography.
import { formatPlace } from "./format.ts";
import type { Point } from "./geometry.ts";
import { type GeoPoint, mgrsOf, Projection, type ProjectionNumbers, utmOf } from "./projection.ts";

export type PlaceNotation = "metres" | "degrees" | "seconds" | "utm" | "mgrs";

/** By their names for people. */
export const kPlaceNotations: readonly (readonly [PlaceNotation, string])[] = [
  ["metres", "Metres of the map"],
  ["degrees", "Degrees"],
  ["seconds", "Degrees, minutes, seconds"],
  ["utm", "UTM"],
  ["mgrs", "MGRS"],
];

/** A place as ODL and `mlab` read it; in degrees where a grid ends. */
export function writtenPlace(place: GeoPoint, notation: Exclude<PlaceNotation, "metres">): string {
  const north = place.latitude < 0 ? "S" : "N";
  const east = place.longitude < 0 ? "W" : "E";
  if (notation === "utm") {
    const utm = utmOf(place);
    if (utm) return `${utm.zone}${utm.isNorth ? "N" : "S"} ${utm.easting.toFixed(2)} ${utm.northing.toFixed(2)}`;
  }
  if (notation === "mgrs") {
    const mgrs = mgrsOf(place);
    if (mgrs) return mgrs;
  }
  if (notation === "seconds") return `${seconds(place.latitude)} ${north} ${seconds(place.longitude)} ${east}`;
  return `${Math.abs(place.latitude).toFixed(7)} ${north} ${Math.abs(place.longitude).toFixed(7)} ${east}`;
}

function seconds(angle: number): string {
  const units = Math.round(Math.abs(angle) * 3600 * 1e4);
  const whole = Math.floor(units / 10_000);
  const two = (value: number): string => String(value).padStart(2, "0");
  const fraction = String(units % 10_000).padStart(4, "0");
  return `${Math.floor(whole / 3600)}°${two(Math.floor(whole / 60) % 60)}'${two(whole % 60)}.${fraction}''`;
}

let last: { numbers: ProjectionNumbers; projection: Projection } | null = null;

/** Of a scene; the last one is kept, since many places are asked of one scene. */
export function projectionOf(scene: { readonly projection?: ProjectionNumbers | undefined } | null): Projection | null {
  const numbers = scene?.projection;
  if (!numbers) return null;
  if (last?.numbers !== numbers) last = { numbers, projection: new Projection(numbers) };
  return last.projection;
}

/** A world point in the notation that was chosen; in metres where the map doesn't say where it lies on the Earth. */
export function placeText(
  scene: { readonly projection?: ProjectionNumbers | undefined } | null,
  { x, y }: Point,
  notation: PlaceNotation,
  pixelsPerMetre: number,
): string {
  const projection = notation === "metres" ? null : projectionOf(scene);
  if (!projection || notation === "metres") return formatPlace(x, y, pixelsPerMetre);
  return writtenPlace(projection.toEarth({ x, y }), notation);
}
