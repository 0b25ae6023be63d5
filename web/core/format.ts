// Numbers as people read them.

/** `12.3 m`, `4.56 km`, `35 cm`. Negative or not finite: unknown. */
export function formatDistance(metres: number): string {
  if (!Number.isFinite(metres)) return "–";
  const size = Math.abs(metres);
  if (size >= 10_000) return `${(metres / 1000).toFixed(1)} km`;
  if (size >= 1000) return `${(metres / 1000).toFixed(2)} km`;
  if (size >= 100) return `${metres.toFixed(0)} m`;
  if (size >= 10) return `${metres.toFixed(1)} m`;
  if (size >= 1 || size === 0) return `${metres.toFixed(2)} m`;
  return `${(metres * 100).toFixed(size < 0.1 ? 1 : 0)} cm`;
}

/** `4.2 s`, `1:05`, `1:02:03`. Negative: unknown. */
export function formatDuration(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds < 0) return "–";
  if (seconds < 59.95) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  const two = (value: number): string => String(value).padStart(2, "0");
  const minutes = Math.floor(whole / 60) % 60;
  const hours = Math.floor(whole / 3600);
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

export function toDegrees(radians: number): number {
  return (radians * 180) / Math.PI;
}

export function toRadians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

/** Counter-clockwise from east, as the mission language has it: `90°`, 0 .. 359. */
export function formatAngle(radians: number): string {
  if (!Number.isFinite(radians)) return "–";
  return `${((Math.round(toDegrees(radians)) % 360) + 360) % 360}°`;
}

/** Clockwise from north, as a compass has it: `045°`. */
export function formatBearing(radians: number): string {
  if (!Number.isFinite(radians)) return "–";
  return `${String((((90 - Math.round(toDegrees(radians))) % 360) + 360) % 360).padStart(3, "0")}°`;
}

export function formatSpeed(metresPerSecond: number): string {
  if (!Number.isFinite(metresPerSecond)) return "–";
  return `${metresPerSecond.toFixed(2)} m/s`;
}

/** As many decimals as a screen of that scale can tell apart. */
export function formatPlace(x: number, y: number, pixelsPerMetre: number): string {
  const decimals = Math.max(0, Math.min(3, Math.ceil(Math.log10(Math.max(pixelsPerMetre, 1e-9)))));
  return `${x.toFixed(decimals)}, ${y.toFixed(decimals)} m`;
}

/** The largest of 1, 2 or 5 times a power of ten that is not above `most`. */
export function roundDown(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  const share = most / power;
  return (share >= 5 ? 5 : share >= 2 ? 2 : 1) * power;
}

/** Robot numbers, runs joined: `1–4, 7`. */
export function idRanges(ids: readonly number[]): string {
  const sorted = [...new Set(ids)].sort((a, b) => a - b);
  const parts: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    let j = i;
    while (j + 1 < sorted.length && sorted[j + 1] === (sorted[j] as number) + 1) j++;
    parts.push(j - i >= 2 ? `${sorted[i]}–${sorted[j]}` : sorted.slice(i, j + 1).join(", "));
    i = j + 1;
  }
  return parts.join(", ");
}
