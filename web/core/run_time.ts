// Moments of a run, as people write and hear them.

/** `2:13.4`, `1:02:03.4`: run time, to a tenth of a second. */
export function momentText(seconds: number): string {
  const tenths = Math.round(Math.max(0, Number.isFinite(seconds) ? seconds : 0) * 10);
  const minutes = Math.floor(tenths / 600);
  const rest = ((tenths % 600) / 10).toFixed(1).padStart(4, "0");
  const hours = Math.floor(minutes / 60);
  return hours > 0 ? `${hours}:${String(minutes % 60).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}

/** `2 min 13.4 s`, `1 h 2 min 3.4 s`. */
export function momentSpoken(seconds: number): string {
  const tenths = Math.round(Math.max(0, Number.isFinite(seconds) ? seconds : 0) * 10);
  const minutes = Math.floor(tenths / 600);
  const hours = Math.floor(minutes / 60);
  const parts = [
    hours > 0 ? `${hours} h` : "",
    minutes > 0 ? `${minutes % 60} min` : "",
    `${((tenths % 600) / 10).toFixed(1)} s`,
  ];
  return parts.filter((part) => part !== "").join(" ");
}

/** Reads `2:13.4`, `1:02:03`, `133.4`, `133.4 s`, `2 min 13.4 s`; nothing where it is no time [s]. */
export function readMoment(text: string): number | undefined {
  const clean = text.trim().toLowerCase().replace(/,/g, ".");
  if (/^\d+(:\d{1,2}){1,2}(\.\d*)?$/.test(clean)) {
    const parts = clean.split(":").map(Number);
    if (parts.slice(1).some((part) => part >= 60)) return undefined;
    return parts.reduce((sum, part) => sum * 60 + part, 0);
  }
  const units = /^(?:(\d+)\s*h)?\s*(?:(\d+)\s*min)?\s*(?:(\d+(?:\.\d*)?|\.\d+)\s*s?)?$/.exec(clean);
  if (!units || clean === "") return undefined;
  const [, hours, minutes, seconds] = units;
  return Number(hours ?? 0) * 3600 + Number(minutes ?? 0) * 60 + Number(seconds ?? 0);
}
