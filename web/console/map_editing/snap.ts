// Points on a grid.

/** The nearest grid point; the point itself where the grid is off (0). */
export function snapPoint(point: { x: number; y: number }, grid: number): { x: number; y: number } {
  return { x: snapNumber(point.x, grid), y: snapNumber(point.y, grid) };
}

export function snapNumber(value: number, grid: number): number {
  if (!(grid > 0)) return value;
  return Number((Math.round(value / grid) * grid).toPrecision(12)) + 0;
}

/** A grid whose lines are some 12 to 30 pixels apart: 1, 2 or 5 times a power of ten [m]. */
export function gridFor(metresPerPixel: number): number {
  if (!(metresPerPixel > 0) || !Number.isFinite(metresPerPixel)) return 1;
  const least = metresPerPixel * 12;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].find((k) => k * power >= least * (1 - 1e-9)) ?? 10;
  return Number((step * power).toPrecision(6));
}

/** To which tools snap at `scale` pixels a metre: fine enough to place things by, coarse enough for round numbers. */
export function toolGrid(scale: number): number {
  return gridFor(1 / (3 * scale));
}

/** How far one press of an arrow key moves: a grid step, ten with Shift, without a grid one pixel. */
export function nudgeOf(
  key: string,
  shift: boolean,
  grid: number,
  metresPerPixel: number,
): { dx: number; dy: number } | null {
  const step = (grid > 0 ? grid : Math.max(metresPerPixel, 1e-3)) * (shift ? 10 : 1);
  switch (key) {
    case "ArrowLeft":
      return { dx: -step, dy: 0 };
    case "ArrowRight":
      return { dx: step, dy: 0 };
    case "ArrowUp":
      return { dx: 0, dy: step };
    case "ArrowDown":
      return { dx: 0, dy: -step };
    default:
      return null;
  }
}
