// What a parameter's slider and number field do.
import type { Port } from "../../core/protocol.ts";

export type ParameterKind = "slider" | "number" | "switch" | "choice" | "text";

export interface Range {
  min: number;
  max: number;
  step: number;
}

export function parameterKind(port: Port): ParameterKind {
  if (port.choices.length > 0) return "choice";
  if (/^bool(ean)?$/i.test(port.type)) return "switch";
  if (!port.isNumber) return "text";
  return port.min !== undefined && port.max !== undefined && port.max > port.min ? "slider" : "number";
}

/** The slider's range: the author's, in about 200 steps of a round size; whole numbers for whole-number types. */
export function sliderRange(port: Port): Range {
  const min = port.min ?? 0;
  const max = port.max ?? 1;
  const isWhole = /^(int|long|unsigned|uint|count)/i.test(port.type);
  const rough = (max - min) / 200;
  const power = 10 ** Math.floor(Math.log10(rough));
  const round = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough) ?? rough;
  return { min, max, step: isWhole ? Math.max(1, Math.round(round)) : round };
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

/** Digits that fit the step of the slider: 0.05 gives `1.25`. */
export function shownNumber(value: number, step: number): string {
  const decimals = Math.max(0, Math.min(8, -Math.floor(Math.log10(step) + 1e-9)));
  return String(Number(value.toFixed(decimals)));
}
