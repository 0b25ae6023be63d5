// Numbers as people read them. Inside everything is metres, seconds and radians.

/** `0:07`, `12:34`, `1:02:03`; tenths where `tenths`. Negative and non-finite times have none: `–`. */
export function duration(seconds: number, tenths = false): string {
  if (!Number.isFinite(seconds) || seconds < 0) return "–";
  const rounded = tenths ? Math.round(seconds * 10) / 10 : Math.floor(seconds + 1e-9);
  const hours = Math.floor(rounded / 3600);
  const minutes = Math.floor((rounded % 3600) / 60);
  const rest = rounded % 60;
  const tail = tenths ? rest.toFixed(1).padStart(4, "0") : String(rest).padStart(2, "0");
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, "0")}:${tail}` : `${minutes}:${tail}`;
}

/** `350 m`, `12.4 m`, `1.24 km`; unknown (negative): `–`. */
export function distance(metres: number): string {
  if (!Number.isFinite(metres) || metres < 0) return "–";
  if (metres >= 10000) return `${(metres / 1000).toFixed(1)} km`;
  if (metres >= 1000) return `${(metres / 1000).toFixed(2)} km`;
  return metres >= 100 ? `${Math.round(metres)} m` : `${metres.toFixed(1)} m`;
}

/** Compact and without noise: `0`, `0.25`, `-1.5`, `12300`, `1.2e-7`. */
export function quantity(value: number, digits = 3): string {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "-∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, "e");
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return trimZeros(value.toFixed(Math.min(decimals, 6)));
}

/** Heading as people say it: degrees, counter-clockwise from east, 0 to 359. */
export function headingDegrees(radians: number): string {
  const degrees = Math.round((radians * 180) / Math.PI) % 360;
  return `${degrees < 0 ? degrees + 360 : degrees}°`;
}

/** `×10`, `×0.5`, `max` (0). */
export function speedFactor(speed: number): string {
  return speed === 0 ? "max" : `×${quantity(speed, 3)}`;
}

/** `1 robot`, `4 robots`. */
export function count(n: number, noun: string, plural = `${noun}s`): string {
  return `${n} ${n === 1 ? noun : plural}`;
}

/** `a`, `a and b`, `a, b and c`. */
export function list(words: readonly string[]): string {
  if (words.length < 2) return words.join("");
  return `${words.slice(0, -1).join(", ")} and ${words[words.length - 1]}`;
}

/**
 * What the server says, as people read it: names in backticks in quotes, and `robot 3` by its one name, `Robot 3`
 * (RosterIndex.nameOf).
 */
export function readableMessage(text: string): string {
  return text.replaceAll(/`([^`]*)`/g, "“$1”").replaceAll(/\brobot(s?) (?=\d)/g, "Robot$1 ");
}

function trimZeros(text: string): string {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}
