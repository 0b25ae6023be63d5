import { describe, expect, it } from "vitest";
import { Projection } from "../projection.ts";
import { layPiece, piecesOf, placeInSquare, squaresIn, zoomFor } from "./tiles.ts";

const kTileSide = 256;
const kWorld = { south: -85, west: -180, north: 85, east: 180, leastZoom: 0, mostZoom: 19 };

/** A map of its own round a place, as the server makes it. */
function mapAround(latitude: number, longitude: number): Projection {
  const numbers = { semiMajor: 6378137, flattening: 1 / 298.257223563, scale: 1, centralMeridian: longitude };
  return new Projection({ ...numbers, origin: new Projection(numbers).toWorld({ latitude, longitude }) });
}

/** How far any point of a square is drawn from where it is, in pixels of the tile. */
function worstError(projection: Projection, square: { zoom: number; column: number; row: number }): number {
  const pieces = piecesOf(square.zoom);
  let worst = 0;
  for (let i = 0; i < pieces; ++i) {
    const laid = layPiece(square, projection, i / pieces, i / pieces, 1 / pieces);
    const pixel = (Math.hypot(laid.across.x, laid.across.y) * pieces) / kTileSide;
    for (let u = 0; u <= 1; u += 0.25) {
      for (let v = 0; v <= 1; v += 0.25) {
        const drawn = {
          x: laid.middle.x + (u - 0.5) * laid.across.x + (v - 0.5) * laid.down.x,
          y: laid.middle.y + (u - 0.5) * laid.across.y + (v - 0.5) * laid.down.y,
        };
        const is = projection.toWorld(placeInSquare(square, (i + u) / pieces, (i + v) / pieces));
        worst = Math.max(worst, Math.hypot(drawn.x - is.x, drawn.y - is.y) / pixel);
      }
    }
  }
  return worst;
}

describe("tiles below the map", () => {
  it("lie within an eighth of their pixel of where they belong", () => {
    for (const [latitude, longitude] of [
      [0.5, 10],
      [48.2, 16.4],
      [-33.9, 151.2],
      [69.6, 18.9],
    ] as const) {
      const projection = mapAround(latitude, longitude);
      for (let zoom = 8; zoom <= 18; ++zoom) {
        for (const at of [
          { x: 0, y: 0 },
          { x: 30_000, y: 30_000 },
        ]) {
          const [square] = squaresIn(
            { xMin: at.x, xMax: at.x + 1, yMin: at.y, yMax: at.y + 1 },
            projection,
            kWorld,
            zoom,
          );
          expect(worstError(projection, square!), `${latitude} ${zoom}`).toBeLessThan(0.125);
        }
      }
    }
  });

  it("are those that can be seen", () => {
    const projection = mapAround(48.2082, 16.3738);
    const box = { xMin: -500, xMax: 500, yMin: -500, yMax: 500 };
    const squares = squaresIn(box, projection, kWorld, 15);
    // 48.2082 N 16.3738 E is in column 17874 and row 11362 of zoom 15, which are 815 m wide there.
    expect(squares).toContainEqual({ zoom: 15, column: 17874, row: 11362 });
    expect(squares.length).toBeLessThanOrEqual(9);
    expect(squaresIn(box, projection, { ...kWorld, south: 50, north: 51 }, 15)).toEqual([]);
    expect(squaresIn({ xMin: 1e6, xMax: 2e6, yMin: 0, yMax: 1 }, projection, kWorld, 15)).toEqual([]);
    expect(squaresIn({ xMin: -1e7, xMax: 1e7, yMin: -1e7, yMax: 1e7 }, projection, kWorld, 18)).toEqual([]);
  });

  it("go on beyond the date line", () => {
    const projection = mapAround(0, 179.9999);
    const squares = squaresIn({ xMin: -200, xMax: 200, yMin: 0, yMax: 1 }, projection, kWorld, 15);
    expect(new Set(squares.map(({ column }) => column))).toEqual(new Set([32767, 32768]));
  });

  it("are of the zoom whose pixels are as large as the screen's", () => {
    expect(zoomFor(1 / 1.194, 0, kWorld)).toBe(17);
    expect(zoomFor(1000, 0, kWorld)).toBe(19);
    expect(zoomFor(1e-6, 0, { leastZoom: 8, mostZoom: 12 })).toBe(8);
  });
});
