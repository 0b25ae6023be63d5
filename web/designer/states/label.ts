// What is written at a transition: its trigger in lines of a length that can be read, and the room that it takes.
import { triggerWords } from "./trigger_words.ts";

export interface LabelSize {
  readonly width: number;
  readonly height: number;
}

const kLetter = 0.602; // width of a letter of the monospaced font, of its size
const kFontSize = 12; // [px]
const kLineHeight = 16; // [px]
const kLineLength = 30; // letters
const kMostLines = 3;
const kShortLength = 16;
const kPadding = { across: 22, down: 8 }; // with the border [px]
const kMarkWidth = 20; // of its number, of the sign that it starts anew [px]

/** The text in lines; `isShort`: in one, cut where it does not fit. */
export function labelLines(trigger: string, isShort = false): string[] {
  const text = triggerWords(trigger).trim().replaceAll(/\s+/g, " ") || "when?";
  if (isShort) return [text.length > kShortLength ? `${text.slice(0, kShortLength - 1)}…` : text];
  const lines: string[] = [];
  let rest = text;
  while (rest.length > kLineLength && lines.length < kMostLines - 1) {
    const end = lineEnd(rest);
    lines.push(rest.slice(0, end).trimEnd());
    rest = rest.slice(end).trimStart();
  }
  lines.push(rest.length > kLineLength ? `${rest.slice(0, kLineLength - 1)}…` : rest);
  return lines;
}

/** Where a line that is too long is best broken: between words, behind a comma or a parenthesis; else anywhere. */
function lineEnd(text: string): number {
  const head = text.slice(0, kLineLength + 1);
  for (const sign of [" and ", " or "]) {
    const at = head.lastIndexOf(sign);
    if (at > kLineLength / 3) return at;
  }
  const comma = head.lastIndexOf(", ");
  if (comma > kLineLength / 3) return comma + 1;
  const open = text.slice(0, kLineLength).lastIndexOf("(");
  if (open > kLineLength / 3) return open + 1;
  const blank = head.lastIndexOf(" ");
  return blank > kLineLength / 3 ? blank : kLineLength;
}

/**
 * `marks`: signs beside the text, its number in the order of asking and whether it starts anew. `scale`: how many times
 * larger than on a canvas of actual size its letters are.
 */
export function labelSize(lines: readonly string[], marks: number, scale = 1): LabelSize {
  const longest = Math.max(...lines.map((line) => line.length));
  return {
    width: Math.ceil((longest * kLetter * kFontSize + kPadding.across + marks * kMarkWidth) * scale),
    height: Math.ceil((lines.length * kLineHeight + kPadding.down) * scale),
  };
}

/** How much larger what is written may be, the largest first. Labels are placed anew with each. */
export const kScales = [3, 2.7, 2.4, 2.05, 1.7, 1.5, 1.35, 1.18, 1] as const;

/** How much larger it has to be, seen from far away. */
export function scaleAt(zoom: number): number {
  if (zoom >= 0.85) return 1;
  if (zoom >= 0.62) return 1.35;
  if (zoom >= 0.48) return 1.7;
  return zoom >= 0.36 ? 2.4 : 3;
}
