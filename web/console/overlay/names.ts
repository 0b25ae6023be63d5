// Names for new control measures, and what is wrong with a name.

import { mdlName } from "../../core/mdl_text.ts";
import { keywordOf, type MeasureKind } from "../../core/measure_kinds.ts";

/** `AA-1`, `PP-2`: the keyword and the first number that no measure has yet. */
export function proposeName(kind: MeasureKind, taken: readonly string[]): string {
  const present = new Set(taken.map((n) => n.toLowerCase()));
  const keyword = keywordOf(kind);
  for (let n = 1; ; ++n) {
    const name = `${keyword}-${n}`;
    if (!present.has(name.toLowerCase())) return name;
  }
}

/** A sentence where a name can't be used or will surprise; empty where it is fine. `others` are those of all other measures. */
export function nameProblem(name: string, others: readonly string[]): { error: string; warning: string } {
  const none = { error: "", warning: "" };
  if (name.trim() === "") return { ...none, warning: "Without a name no command can refer to it." };
  if (name !== name.trim()) return { ...none, error: "A name neither begins nor ends with a blank." };
  if (name.includes('"')) return { ...none, error: "A name can't hold a quotation mark." };
  if (mdlName(name) === null) return { ...none, error: "A name stands on one line." };
  if (name.endsWith("*")) return { ...none, error: "A * at the end hides the label: use “Show label” for that." };
  if (others.includes(name))
    return { ...none, error: `There is another ${name}: commands would find only one of them.` };
  const similar = others.find((o) => o.toLowerCase() === name.toLowerCase());
  if (similar !== undefined) return { ...none, warning: `${similar} differs only in letter case.` };
  return none;
}
