// Round numbers for axes.

/** About `wanted` multiples of 1, 2 or 5 times a power of ten inside [from, to]. */
export function niceTicks(from: number, to: number, wanted: number): number[] {
  const span = to - from;
  if (!(span > 0) || !Number.isFinite(span)) return Number.isFinite(from) ? [from] : [];
  const rough = span / Math.max(wanted, 1);
  const exponent = Math.floor(Math.log10(rough));
  const factor = rough / 10 ** exponent;
  const step = (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10) * 10 ** exponent;
  const first = Math.ceil(from / step);
  const last = Math.floor(to / step + 1e-9);
  // So far from zero numbers lie too far apart to tell ticks from each other.
  if (!Number.isSafeInteger(first) || !Number.isSafeInteger(last)) return [from];
  return Array.from({ length: last - first + 1 }, (_, i) => rounded((first + i) * step, -exponent));
}

/** Without the noise of binary fractions. */
function rounded(value: number, decimals: number): number {
  return decimals > 100 ? value : Number(value.toFixed(Math.max(decimals, 0))) + 0;
}

/** For the legend: four digits that say something. */
export function valueText(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-3)) return value.toExponential(2);
  return value.toFixed(size >= 100 ? 1 : size >= 10 ? 2 : 3);
}
