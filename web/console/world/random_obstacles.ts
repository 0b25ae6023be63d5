// The dialog's settings for obstacles at random, and what they would lead to.

export interface RandomObstacles {
  /** Per cent of the area, 0 to 30. */
  readonly coverage: number;
  readonly minRadius: number;
  readonly maxRadius: number;
  /** 0: one is chosen. */
  readonly seed: number;
  readonly replace: boolean;
}

export interface Area {
  readonly width: number;
  readonly height: number;
}

export const kMaxSeed = 0xffffffff;

/** From a thousandth to a fifth of the area's shorter side. */
export function radiusLimits(area: Area): { min: number; max: number } {
  const shorter = Math.max(Math.min(area.width, area.height), 0);
  return { min: shorter / 1000, max: shorter / 5 };
}

/** 3 %, radii of 2 to 10 m where these fit the area. */
export function defaultRandomObstacles(area: Area): RandomObstacles {
  const { min, max } = radiusLimits(area);
  const fit = (r: number) => Math.min(Math.max(r, min), max);
  return { coverage: 3, minRadius: fit(2), maxRadius: fit(10), seed: 0, replace: true };
}

/** How many there will be, about: discs of radii evenly spread over [min, max] until the coverage is reached. */
export function expectedCount(o: RandomObstacles, area: Area, standing: readonly number[]): number {
  const { minRadius: a, maxRadius: b } = o;
  const meanDisc = (Math.PI * (a * a + a * b + b * b)) / 3;
  if (!(meanDisc > 0)) return 0;
  const there = o.replace ? 0 : standing.reduce((sum, r) => sum + Math.PI * r * r, 0);
  const wanted = (o.coverage / 100) * area.width * area.height - there;
  return wanted <= 0 ? 0 : Math.ceil(wanted / meanDisc);
}

/** What keeps the settings from being used, and what will surprise; sentences. */
export function problemsOf(o: RandomObstacles, area: Area, count: number): { errors: string[]; warnings: string[] } {
  const errors: string[] = [];
  const warnings: string[] = [];
  const { min, max } = radiusLimits(area);
  const isRadius = (r: number) => r >= min * (1 - 1e-9) && r <= max * (1 + 1e-9);
  if (!(o.coverage >= 0 && o.coverage <= 30)) errors.push("Coverage is 0 to 30 per cent.");
  if (!isRadius(o.minRadius) || !isRadius(o.maxRadius))
    errors.push(`Radii are ${short(min)} to ${short(max)} m on this area.`);
  if (o.minRadius > o.maxRadius) errors.push("The smallest radius is larger than the largest one.");
  if (!Number.isInteger(o.seed) || o.seed < 0 || o.seed > kMaxSeed)
    errors.push(`The seed is a whole number from 0 to ${kMaxSeed}.`);
  if (o.coverage > 20) warnings.push("Above 20 per cent there may be no way through.");
  if (count > 100) warnings.push("More than 100 obstacles make the simulation slower.");
  if (errors.length === 0 && count === 0 && !o.replace)
    warnings.push("What stands covers as much already: nothing will be added.");
  return { errors, warnings };
}

function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}

/** A seed that can be said over the telephone: up to six digits, from random bits. */
export function seedFrom(bits: number): number {
  return (Math.abs(Math.trunc(bits)) % 999_999) + 1;
}
