// Where the world lies on the Earth: the transverse Mercator projection that the server tells, and the grids that places are
// written in. The same figures as src/mlab/geography, which a test of both holds against one table: a read-out that follows
// the pointer can't ask the server for each place.
import type { Point } from "./geometry.ts";

/** [degrees], north and east are positive */
export interface GeoPoint {
  readonly latitude: number;
  readonly longitude: number;
}

/** What is needed of the message. */
export interface ProjectionNumbers {
  readonly semiMajor: number; // [m]
  readonly flattening: number;
  readonly scale: number;
  readonly centralMeridian: number; // [degrees]
  readonly origin?: Point | undefined; // where the world's (0, 0) is [m]
}

const kWgs84 = { semiMajor: 6378137, flattening: 1 / 298.257223563 };

const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const degrees = (angle: number): number => (angle * 180) / Math.PI;
/** Within 180 degrees. */
const wrapped = (angle: number): number => angle - 360 * Math.round(angle / 360);

/**
 * Krüger's series to the fourth order of the third flattening, better than a tenth of a millimetre within 1000 km of the middle
 * meridian. The letters are those of C. F. F. Karney, "Transverse Mercator with an accuracy of a few nanometers" (2011).
 */
export class Projection {
  private readonly radius: number;
  private readonly e2: number;
  private readonly alpha: readonly number[];
  private readonly beta: readonly number[];
  private readonly middle: number;
  private readonly origin: Point;

  constructor(of: ProjectionNumbers) {
    const n = of.flattening / (2 - of.flattening);
    const n2 = n * n;
    const n3 = n2 * n;
    const n4 = n3 * n;
    this.radius = ((of.scale * of.semiMajor) / (1 + n)) * (1 + n2 / 4 + n4 / 64);
    this.e2 = of.flattening * (2 - of.flattening);
    this.alpha = [
      n / 2 - (2 / 3) * n2 + (5 / 16) * n3 + (41 / 180) * n4,
      (13 / 48) * n2 - (3 / 5) * n3 + (557 / 1440) * n4,
      (61 / 240) * n3 - (103 / 140) * n4,
      (49561 / 161280) * n4,
    ];
    this.beta = [
      n / 2 - (2 / 3) * n2 + (37 / 96) * n3 - (1 / 360) * n4,
      (1 / 48) * n2 + (1 / 15) * n3 - (437 / 1440) * n4,
      (17 / 480) * n3 - (37 / 840) * n4,
      (4397 / 161280) * n4,
    ];
    this.middle = of.centralMeridian;
    this.origin = of.origin ?? { x: 0, y: 0 };
  }

  toWorld({ latitude, longitude }: GeoPoint): Point {
    const lambda = radians(wrapped(longitude - this.middle));
    const tau = this.conformal(Math.tan(radians(latitude)));
    const xi = Math.atan2(tau, Math.cos(lambda));
    const eta = Math.asinh(Math.sin(lambda) / Math.hypot(tau, Math.cos(lambda)));
    let [x, y] = [eta, xi];
    this.alpha.forEach((a, i) => {
      const j = 2 * (i + 1);
      y += a * Math.sin(j * xi) * Math.cosh(j * eta);
      x += a * Math.cos(j * xi) * Math.sinh(j * eta);
    });
    return { x: this.radius * x - this.origin.x, y: this.radius * y - this.origin.y };
  }

  toEarth(world: Point): GeoPoint {
    const xi = (world.y + this.origin.y) / this.radius;
    const eta = (world.x + this.origin.x) / this.radius;
    let [x, y] = [eta, xi];
    this.beta.forEach((b, i) => {
      const j = 2 * (i + 1);
      y -= b * Math.sin(j * xi) * Math.cosh(j * eta);
      x -= b * Math.cos(j * xi) * Math.sinh(j * eta);
    });
    const tau = this.geographic(Math.sin(y) / Math.hypot(Math.sinh(x), Math.cos(y)));
    return {
      latitude: degrees(Math.atan(tau)),
      longitude: wrapped(this.middle + degrees(Math.atan2(Math.sinh(x), Math.cos(y)))),
    };
  }

  /** Tangent of the conformal latitude, of that of the latitude. */
  private conformal(tau: number): number {
    const secant = Math.hypot(1, tau);
    const e = Math.sqrt(this.e2);
    const sigma = Math.sinh(e * Math.atanh((e * tau) / secant));
    return Math.hypot(1, sigma) * tau - sigma * secant;
  }

  /** The other way round, by Newton's method: two steps are enough, the third changes nothing. */
  private geographic(conformal: number): number {
    let tau = conformal / (1 - this.e2);
    for (let i = 0; i < 3; ++i) {
      const now = this.conformal(tau);
      const share = (1 + (1 - this.e2) * tau * tau) / ((1 - this.e2) * Math.hypot(1, tau));
      tau += ((conformal - now) / Math.hypot(1, now)) * share;
    }
    return tau;
  }
}

export interface Utm {
  readonly zone: number;
  readonly isNorth: boolean;
  readonly easting: number; // [m]
  readonly northing: number; // [m]
}

/** With the exceptions of Norway and Svalbard. */
function zoneOf({ latitude, longitude }: GeoPoint): number {
  const east = wrapped(longitude);
  if (latitude >= 56 && latitude < 64 && east >= 3 && east < 12) return 32;
  if (latitude >= 72 && east >= 0 && east < 42) return east < 9 ? 31 : east < 21 ? 33 : east < 33 ? 35 : 37;
  return (Math.floor((east + 180) / 6) % 60) + 1;
}

/** null where the grid ends: beyond 80 S and 84 N. */
export function utmOf(place: GeoPoint): Utm | null {
  if (!(place.latitude >= -80 && place.latitude <= 84)) return null;
  const zone = zoneOf(place);
  const isNorth = place.latitude >= 0;
  const { x, y } = gridOf(zone).toWorld(place);
  return { zone, isNorth, easting: 500_000 + x, northing: isNorth ? y : 10_000_000 + y };
}

const grids = new Map<number, Projection>();
function gridOf(zone: number): Projection {
  const known = grids.get(zone);
  if (known) return known;
  const made = new Projection({ ...kWgs84, scale: 0.9996, centralMeridian: zone * 6 - 183 });
  grids.set(zone, made);
  return made;
}

const kColumns = ["ABCDEFGH", "JKLMNPQR", "STUVWXYZ"];
const kRows = "ABCDEFGHJKLMNPQRSTUV";
const kBands = "CDEFGHJKLMNPQRSTUVWX";
const kSquare = 100_000; // m

/** The square with a side of a metre: `33UXP0206540353`. null where the grid ends. */
export function mgrsOf(place: GeoPoint): string | null {
  const utm = utmOf(place);
  if (!utm) return null;
  const band = kBands.charAt(Math.min(19, Math.floor((place.latitude + 80) / 8)));
  const column = kColumns[(utm.zone - 1) % 3]?.charAt(Math.floor(utm.easting / kSquare) - 1);
  const row = kRows.charAt((Math.floor(utm.northing / kSquare) + (utm.zone % 2 === 0 ? 5 : 0)) % 20);
  const five = (metres: number): string => String(Math.floor(metres % kSquare)).padStart(5, "0");
  return `${String(utm.zone).padStart(2, "0")}${band}${column}${row}${five(utm.easting)}${five(utm.northing)}`;
}
