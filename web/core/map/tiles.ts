// A map of the Earth below ours: squares of Web Mercator, each laid where its corners are in the world.
import type { Box, Point } from "../geometry.ts";
import type { GeoPoint, Projection } from "../projection.ts";
import type { Tiles } from "../protocol.ts";

const kMetresOfAPixel = 156_543.034; // at the equator, zoom 0
const kMostTiles = 300; // on the screen: more is a map that is looked at from too far
const kFinest = 12; // zoom from which a tile is laid in one piece; those of lower ones in pieces as small as these
const kReach = 150_000; // [m] from the map's origin, in x and y

/** A square: column from 180 degrees west, row from the north. Columns go on beyond the date line. */
export interface Square {
  readonly zoom: number;
  readonly column: number;
  readonly row: number;
}

/** Where a point of a square is on the Earth; `u` from its west, `v` from its north, 0 to 1. */
export function placeInSquare({ zoom, column, row }: Square, u: number, v: number): GeoPoint {
  const side = 2 ** zoom;
  return {
    longitude: ((column + u) / side) * 360 - 180,
    latitude: (Math.atan(Math.sinh(Math.PI * (1 - (2 * (row + v)) / side))) * 180) / Math.PI,
  };
}

function columnOf(longitude: number, zoom: number): number {
  return Math.floor(((longitude + 180) / 360) * 2 ** zoom);
}
function rowOf(latitude: number, zoom: number): number {
  const angle = (Math.max(-85.05, Math.min(85.05, latitude)) * Math.PI) / 180;
  return Math.floor(((1 - Math.asinh(Math.tan(angle)) / Math.PI) / 2) * 2 ** zoom);
}

/** The zoom whose pixels are nearest to those of the screen. [pixels per metre] */
export function zoomFor(scale: number, latitude: number, tiles: Pick<Tiles, "leastZoom" | "mostZoom">): number {
  const wanted = Math.round(Math.log2(kMetresOfAPixel * Math.cos((latitude * Math.PI) / 180) * scale));
  return Math.max(tiles.leastZoom, Math.min(tiles.mostZoom, wanted));
}

/** The squares that can be seen; none where there would be too many. */
export function squaresIn(
  box: Box,
  projection: Projection,
  tiles: Pick<Tiles, "south" | "west" | "north" | "east">,
  zoom: number,
): Square[] {
  const around = boundsOnEarth(box, projection);
  if (!around) return [];
  const first = rowOf(Math.min(around.north, tiles.north), zoom);
  const last = rowOf(Math.max(around.south, tiles.south), zoom);
  const left = columnOf(around.west, zoom);
  const right = columnOf(around.east, zoom);
  if ((last - first + 1) * (right - left + 1) > kMostTiles) return [];
  const out: Square[] = [];
  for (let row = first; row <= last; ++row) {
    for (let column = left; column <= right; ++column) out.push({ zoom, column, row });
  }
  return out;
}

/** Longitudes are not wrapped: on a map at the date line they go on. null where nothing of the box is near the origin. */
function boundsOnEarth(box: Box, projection: Projection) {
  const xMin = Math.max(box.xMin, -kReach);
  const xMax = Math.min(box.xMax, kReach);
  const yMin = Math.max(box.yMin, -kReach);
  const yMax = Math.min(box.yMax, kReach);
  if (xMin >= xMax || yMin >= yMax) return null;
  const middle = projection.toEarth({ x: 0, y: 0 }).longitude;
  const bounds = { south: 90, north: -90, west: 1000, east: -1000 };
  for (let i = 0; i <= 8; ++i) {
    const x = xMin + ((xMax - xMin) * i) / 8;
    const y = yMin + ((yMax - yMin) * i) / 8;
    for (const at of [
      { x, y: yMin },
      { x, y: yMax },
      { x: xMin, y },
      { x: xMax, y },
    ]) {
      // its edges
      const { latitude, longitude } = projection.toEarth(at);
      const east = middle + (longitude - middle - 360 * Math.round((longitude - middle) / 360));
      bounds.south = Math.min(bounds.south, latitude);
      bounds.north = Math.max(bounds.north, latitude);
      bounds.west = Math.min(bounds.west, east);
      bounds.east = Math.max(bounds.east, east);
    }
  }
  return bounds;
}

/** Lays a piece of a square, `u` and `v` from 0 to 1 across it, into the world: nearest to where all four corners are. */
export interface Laid {
  readonly middle: Point;
  readonly across: Point; // from its west to its east
  readonly down: Point; // from its north to its south
}

export function layPiece(square: Square, projection: Projection, u: number, v: number, size: number): Laid {
  const at = (du: number, dv: number) => projection.toWorld(placeInSquare(square, u + du * size, v + dv * size));
  const [nw, ne, sw, se] = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
  return {
    middle: { x: (nw.x + ne.x + sw.x + se.x) / 4, y: (nw.y + ne.y + sw.y + se.y) / 4 },
    across: { x: (ne.x - nw.x + se.x - sw.x) / 2, y: (ne.y - nw.y + se.y - sw.y) / 2 },
    down: { x: (sw.x - nw.x + se.x - ne.x) / 2, y: (sw.y - nw.y + se.y - ne.y) / 2 },
  };
}

/** In how many pieces, across and down. */
export function piecesOf(zoom: number): number {
  return 2 ** Math.max(0, Math.min(4, kFinest - zoom));
}
