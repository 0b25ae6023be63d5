// The ODL statement that a control measure means, to be shown beside the map. The server writes the text itself.

import type { Point } from "../../core/geometry.ts";
import { mdlName, mdlNumber } from "../../core/mdl_text.ts";
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";

export interface MeasureText {
  readonly kind: MeasureKind;
  readonly name: string;
  readonly showsLabel: boolean;
  readonly points: readonly Point[];
  readonly centerline: readonly Point[];
  /** 0: the default, not written. */
  readonly size: number;
}

/** `PP Charlie 350 400 10`. A name that can't be written becomes the empty string. */
export function odlText(measure: MeasureText): string {
  const info = kindInfo(measure.kind);
  const head = `${info.keyword} ${nameText(measure.name, measure.showsLabel)}`;
  const size = info.sizeLabel !== "" && measure.size > 0 ? ` ${mdlNumber(measure.size)}` : "";
  if (measure.kind === "hallway") {
    const width = mdlNumber(measure.size > 0 ? measure.size : info.defaultSize);
    return `${head} CENTERLINE ${pointsText(measure.centerline)} WIDTH ${width} EXTENTS ${pointsText(measure.points)}`;
  }
  return `${head} ${pointsText(measure.points)}${size}`;
}

function nameText(name: string, showsLabel: boolean): string {
  const star = showsLabel ? "" : "*";
  const written = mdlName(name);
  if (written === null) return `"${star}"`;
  return written.startsWith('"') ? `"${name}${star}"` : `${name}${star}`;
}

function pointsText(points: readonly Point[]): string {
  return points.map((p) => `${mdlNumber(p.x)} ${mdlNumber(p.y)}`).join("  ");
}

/** Points as a person types them: pairs of numbers, with blanks, commas, semicolons or line ends between. */
export function parsePoints(text: string): { points: Point[] } | { error: string } {
  const words = text.split(/[\s,;()]+/).filter((w) => w !== "");
  const numbers: number[] = [];
  for (const word of words) {
    const value = Number(word);
    if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word) || !Number.isFinite(value))
      return { error: `${word} is no number.` };
    if (Math.abs(value) > 1e8) return { error: `${word} is off every map.` };
    numbers.push(value);
  }
  if (numbers.length % 2 !== 0) return { error: "Each point needs two numbers, x and y." };
  const points: Point[] = [];
  for (let i = 0; i < numbers.length; i += 2) points.push({ x: numbers[i] as number, y: numbers[i + 1] as number });
  return { points };
}

/** The inverse of parsePoints: one point a line. */
export function pointLines(points: readonly Point[]): string {
  return points.map((p) => `${mdlNumber(p.x)} ${mdlNumber(p.y)}`).join("\n");
}
