// What an input takes, in words: its unit, its range, what it is where nothing is said.
import { flowOf, isWholeNumber } from "../../core/value_types.ts";

const kUnits: Readonly<Record<string, string>> = {
  m: "metres",
  s: "seconds",
  rad: "radians",
  deg: "degrees",
  "m/s": "metres per second",
  "m/s^2": "metres per second squared",
  "rad/s": "radians per second",
  "deg/s": "degrees per second",
  Hz: "times a second",
  kg: "kilograms",
  N: "newtons",
  K: "kelvins",
  lx: "lux",
};

export function unitWords(unit: string): string {
  return kUnits[unit] ?? unit;
}

/** `a number, in seconds`; what is not a number keeps its name. */
export function typeWords(type: string, unit: string): string {
  if (flowOf(type) === "flag") return "true or false";
  const plain = flowOf(type) === "number" ? (isWholeNumber(type) ? "a whole number" : "a number") : type;
  return unit ? `${plain}, in ${unitWords(unit)}` : plain;
}

/** What stands above the field: `persistence, in seconds`. */
export function fieldLabel(label: string, type: string, unit: string): string {
  if (type === "") return label;
  return flowOf(type) === "number" && unit ? `${label}, in ${unitWords(unit)}` : `${label}, ${typeWords(type, unit)}`;
}

/** One end of a range: `0.5 m`, `30 deg` where radians would say nothing to most people. */
export function endWords(value: number, unit: string): string {
  const isTurn = unit === "rad" || unit === "rad/s";
  const shown = Number((isTurn ? (value * 180) / Math.PI : value).toPrecision(3));
  const named = isTurn ? unit.replace("rad", "deg") : unit;
  return named ? `${shown} ${named}` : String(shown);
}

interface Limits {
  min?: number | undefined;
  max?: number | undefined;
  initial: string;
  unit: string;
}

/** Larger than anything that is meant: such an end is none. */
const kNoEnd = 1e6;

/** `0 s to 100 s, default 6 s`; empty: there is nothing to say. */
export function limitWords({ min, max, initial, unit }: Limits): string {
  const low = min !== undefined && min > -kNoEnd ? endWords(min, unit) : "";
  const high = max !== undefined && max < kNoEnd ? endWords(max, unit) : "";
  const range = low && high ? `${low} to ${high}` : low ? `at least ${low}` : high ? `at most ${high}` : "";
  const parts = [range, initial === "" ? "" : `default ${withUnit(initial, unit)}`].filter((part) => part !== "");
  const words = parts.join(", ");
  return words === "" ? "" : `${words[0]!.toUpperCase()}${words.slice(1)}.`;
}

/** A bare number is in the input's own unit, and gets it. */
export function withUnit(value: string, unit: string): string {
  return unit !== "" && /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(value.trim()) ? `${value} ${unit}` : value;
}
