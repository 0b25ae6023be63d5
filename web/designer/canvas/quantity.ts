// Numbers with units, as a slider moves them.

/** The number that a text begins with, where the rest is a unit or nothing. */
export function numberIn(text: string): number | undefined {
  const found = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([A-Za-z%/]*)\s*$/i.exec(text);
  return found ? Number(found[1]) : undefined;
}

/** A new number, with the unit that was written before, or else the input's. */
export function sliderValue(value: number, before: string, unit: string): string {
  const written = /[A-Za-z%][A-Za-z%/]*\s*$/.exec(before)?.[0].trim() ?? "";
  const shown = String(Number(value.toPrecision(3)));
  const named = written || unit;
  return named ? `${shown} ${named}` : shown;
}
