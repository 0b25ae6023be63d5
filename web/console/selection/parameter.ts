// What a parameter's slider and number field do.
import type { Port } from "../../core/protocol.ts";
import { type Scale, sliderScale } from "../../core/slider_scale.ts";

export type ParameterKind = "slider" | "number" | "switch" | "choice" | "text";

export function parameterKind(port: Port): ParameterKind {
  if (port.choices.length > 0) return "choice";
  if (/^bool(ean)?$/i.test(port.type)) return "switch";
  if (!port.isNumber) return "text";
  return port.min !== undefined && port.max !== undefined && port.max > port.min ? "slider" : "number";
}

/** The scale of its slider: authors give wide ranges; the usual value then stands well inside of it. */
export function sliderOf(port: Port): Scale {
  const isWhole = /^(int|long|unsigned|uint|count)/i.test(port.type);
  return sliderScale({ min: port.min ?? 0, max: port.max ?? 1, usual: valueNumber(port.initial), isWhole });
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
