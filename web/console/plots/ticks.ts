// Round numbers for axes.

/** About `wanted` multiples of 1, 2 or 5 times a power of ten inside [from, to]. */
export function niceTicks(from: number, to: number, wanted: number): number[] {
  const span = to - from;
  if (!(span > 0) || !Number.isFinite(span)) return Number.isFinite(from) ? [from] : [];
  const rough = span / Math.max(wanted, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const factor = rough / power;
  const step = (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10) * power;
  const ticks: number[] = [];
  for (let k = Math.ceil(from / step); k * step <= to + step * 1e-9; ++k) ticks.push(clean(k * step));
  return ticks;
}

/** Without the noise of binary fractions. */
export function tickText(value: number): string {
  return String(clean(value));
}

function clean(value: number): number {
  const rounded = Number(value.toPrecision(10));
  return rounded === 0 ? 0 : rounded;
}

/** For the legend: four digits that say something. */
export function valueText(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-3)) return value.toExponential(2);
  return value.toFixed(size >= 100 ? 1 : size >= 10 ? 2 : 3);
}
