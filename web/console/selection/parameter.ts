// What a parameter's slider and number field do.
import type { Port } from "../../core/protocol.ts";

export type ParameterKind = "slider" | "number" | "switch" | "choice" | "text";

export function parameterKind(port: Port): ParameterKind {
  if (port.choices.length > 0) return "choice";
  if (/^bool(ean)?$/i.test(port.type)) return "switch";
  if (!port.isNumber) return "text";
  return port.min !== undefined && port.max !== undefined && port.max > port.min ? "slider" : "number";
}

/** Places of a slider. */
export const kSliderEnd = 1000;

/** A slider's places and the values there. Authors give wide ranges; the usual value then stands well inside of it. */
export interface Curve {
  min: number;
  max: number;
  isWhole: boolean;
  /** The value grows with this power of the place: 1 is even. */
  power: number;
}

const kUsualPlace = 0.4; // of the slider, for the value that the program was written with

export function sliderCurve(port: Port): Curve {
  const min = port.min ?? 0;
  const max = port.max ?? 1;
  const isWhole = /^(int|long|unsigned|uint|count)/i.test(port.type);
  const usual = (valueNumber(port.initial) - min) / (max - min);
  const isLow = usual > 0 && usual < kUsualPlace / 2;
  const power = isLow ? Math.min(6, Math.log(usual) / Math.log(kUsualPlace)) : 1;
  return { min, max, isWhole, power };
}

export function placeOnSlider(curve: Curve, value: number): number {
  const share = Math.min(1, Math.max(0, (value - curve.min) / (curve.max - curve.min)));
  return Math.round(kSliderEnd * share ** (1 / curve.power));
}

/** The value there, with no more digits than a hand can mean; the ends are the range's own. */
export function valueOnSlider(curve: Curve, place: number): number {
  if (place <= 0) return curve.min;
  if (place >= kSliderEnd) return curve.max;
  const value = curve.min + (curve.max - curve.min) * (place / kSliderEnd) ** curve.power;
  if (curve.isWhole) return Math.round(value);
  const step = 10 ** (Math.floor(Math.log10(Math.max(Math.abs(value), (curve.max - curve.min) * 1e-6))) - 2) * 2;
  return Number((Math.round(value / step) * step).toPrecision(6));
}

/** Why `text` can't be the value; nothing: it can. */
export function parameterProblem(port: Port, text: string): string | undefined {
  const trimmed = text.trim();
  if (port.choices.length > 0) {
    return port.choices.includes(trimmed) ? undefined : `One of ${port.choices.join(", ")}.`;
  }
  if (!port.isNumber) return undefined;
  const value = Number(trimmed);
  if (trimmed === "" || !Number.isFinite(value)) return "A number is needed.";
  if (port.min !== undefined && value < port.min) return `At least ${port.min}.`;
  if (port.max !== undefined && value > port.max) return `At most ${port.max}.`;
  return undefined;
}

/** The number in a value as it is shown: `2.5 m`, `90 deg`; NaN: none. */
export function valueNumber(shown: string): number {
  const match = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)/i.exec(shown);
  return match ? Number(match[1]) : Number.NaN;
}

export function isSwitchedOn(shown: string): boolean {
  return /^(true|on|yes|1(\.0*)?)$/i.test(shown.trim());
}
