// What the map shows and how: values that can be saved as they are, and undone.
import type { PlaceNotation } from "./place_notation.ts";

export type LayerName =
  | "tiles"
  | "picture"
  | "grid"
  | "measures"
  | "obstacles"
  | "objects"
  | "labels"
  | "trails"
  | "shares"
  | "robots"
  | "stations"
  | "vectors"
  | "readings"
  | "decorations";

export interface MapSettings {
  readonly theme: "light" | "dark";
  /** Symbols of MIL-STD-2525 instead of plain outlines. */
  readonly military: boolean;
  readonly layers: Readonly<Record<LayerName, boolean>>;
  readonly trails: "fade" | "stay";
  readonly robotLabels: "none" | "selected" | "all";
  /** A ring round each robot, to find it when zoomed far out. */
  readonly circleRobots: boolean;
  /** Obstacles that push a watched robot change their look. */
  readonly highlightObstacles: boolean;
  /** Of watched robots, what each schema contributes; else the sum alone. */
  readonly contributions: boolean;
  /** How places are written, where the map says where it lies on the Earth. */
  readonly notation: PlaceNotation;
  /** Robots are drawn so many times larger than they are. */
  readonly robotScale: number;
  /** What draws the robots: "auto" measures and chooses. */
  readonly renderer: "auto" | "webgl" | "canvas";
}

/** The layers by their names for people, in the order of a legend. */
export const kLayers: readonly (readonly [LayerName, string])[] = [
  ["tiles", "Map of the Earth"],
  ["picture", "Background picture"],
  ["grid", "Grid"],
  ["measures", "Control measures"],
  ["obstacles", "Obstacles"],
  ["objects", "Objects"],
  ["labels", "Names"],
  ["trails", "Trails"],
  ["shares", "Shared places and pieces"],
  ["robots", "Robots"],
  ["stations", "Formation stations"],
  ["vectors", "Movement vectors"],
  ["readings", "Sensor readings"],
  ["decorations", "Scale and compass"],
];

export const kDefaultSettings: MapSettings = {
  theme: "light",
  military: false,
  layers: {
    tiles: true,
    picture: true,
    grid: true,
    measures: true,
    obstacles: true,
    objects: true,
    labels: true,
    trails: true,
    shares: true,
    robots: true,
    stations: false,
    vectors: false,
    readings: true,
    decorations: true,
  },
  trails: "fade",
  robotLabels: "selected",
  circleRobots: false,
  highlightObstacles: true,
  contributions: true,
  notation: "metres",
  robotScale: 1,
  renderer: "auto",
};

export function withLayer(settings: MapSettings, layer: LayerName, shown: boolean): MapSettings {
  return { ...settings, layers: { ...settings.layers, [layer]: shown } };
}

/** What a mission's SET says about the map, applied to the settings when it changes. */
export function applyMissionOptions(
  settings: MapSettings,
  before: readonly string[],
  now: readonly string[],
): MapSettings {
  let result = settings;
  const changed = (option: string): boolean => before.includes(option) !== now.includes(option);
  const on = (option: string): boolean => now.includes(option);
  if (changed("USE-MILITARY-STYLE")) result = { ...result, military: on("USE-MILITARY-STYLE") };
  if (changed("SHOW-TRAILS")) result = withLayer(result, "trails", on("SHOW-TRAILS"));
  if (changed("SHOW-MOVEMENT-VECTORS")) result = withLayer(result, "vectors", on("SHOW-MOVEMENT-VECTORS"));
  if (changed("HIGHLIGHT-REPELLING-OBSTACLES"))
    result = { ...result, highlightObstacles: on("HIGHLIGHT-REPELLING-OBSTACLES") };
  return result;
}
