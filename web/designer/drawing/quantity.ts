// Numbers with units, as a slider moves them.

interface WrittenNumber {
  number: number;
  unit: string;
}

/** The number that a text begins with, and its unit; nothing: the rest is something else. */
export function numberWithUnit(text: string): WrittenNumber | undefined {
  const found = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([A-Za-z%/]*)\s*$/i.exec(text);
  return found ? { number: Number(found[1]), unit: found[2]! } : undefined;
}

/** Of what, and how much of it in SI. */
const kUnits: Record<string, readonly [string, number]> = {
  m: ["length", 1],
  cm: ["length", 0.01],
  mm: ["length", 0.001],
  km: ["length", 1000],
  ft: ["length", 0.3048],
  s: ["time", 1],
  ms: ["time", 0.001],
  min: ["time", 60],
  h: ["time", 3600],
  rad: ["angle", 1],
  deg: ["angle", Math.PI / 180],
};

/** How many of the second unit are one of the first; nothing: they are of different things. */
function ratio(from: string, to: string): number | undefined {
  if (from === to) return 1;
  const [over, under, ...more] = from.split("/");
  const [overTo, underTo, ...moreTo] = to.split("/");
  if (more.length + moreTo.length > 0 || (under === undefined) !== (underTo === undefined)) return undefined;
  const upper = one(over!, overTo!);
  const lower = under === undefined ? 1 : one(under, underTo!);
  return upper === undefined || lower === undefined ? undefined : upper / lower;
}

function one(from: string, to: string): number | undefined {
  if (from === to) return 1;
  const [a, b] = [kUnits[from], kUnits[to]];
  return a && b && a[0] === b[0] ? a[1] / b[1] : undefined;
}

/** What is written, in the input's own unit; nothing: it is no number, or of another thing. */
export function numberIn(text: string, unit = ""): number | undefined {
  const found = numberWithUnit(text);
  if (!found) return undefined;
  const times = found.unit === "" ? 1 : ratio(found.unit, unit);
  return times === undefined ? undefined : tidy(found.number * times);
}

/** A new value of the input, in the unit that was written before, or else the input's. */
export function sliderValue(value: number, before: string, unit: string): string {
  const named = numberWithUnit(before)?.unit || unit;
  const times = named === "" ? 1 : (ratio(unit, named) ?? 1);
  const shown = String(Number((value * times).toPrecision(3)));
  return named ? `${shown} ${named}` : shown;
}

/** Without what conversion leaves in the last digits. */
function tidy(value: number): number {
  return Number(value.toPrecision(12));
}
