// A port's value as it stands beside a wire: short, with the digits that mean something.
import { quantity } from "../../ui/words/format.ts";

const kMostLetters = 26;
const kInfinite = /(?<![\w.])\+?(-?)inf(?:inity)?(?!\w)/gi;
const kNoNumber = /(?<![\w.])[-+]?nan(?!\w)/gi;
const kNumber = /[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi;

/** Words as they are; numbers with three digits; cut where it is long. */
export function shownText(text: string, unit: string): string {
  const finite = text.replace(kInfinite, "$1∞").replace(kNoNumber, "no number");
  // Digits that are part of a name (`Robot2`) stay.
  const short = finite.replace(kNumber, (found, at: number) =>
    at > 0 && /[A-Za-z_]/.test(finite[at - 1]!) ? found : quantity(Number(found)),
  );
  const cut = short.length > kMostLetters ? `${short.slice(0, kMostLetters - 1)}…` : short;
  return unit !== "" && /^[-+.\d∞]/.test(cut) && !cut.includes(",") ? `${cut} ${unit}` : cut;
}

/** A vector by its length. */
export function shownVector(x: number, y: number, unit: string): string {
  const length = quantity(Math.hypot(x, y), 2);
  return unit === "" ? length : `${length} ${unit}`;
}
