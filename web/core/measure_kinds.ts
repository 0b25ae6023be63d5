// The control measures that can be drawn.
import { kindInfo, kKinds, type MeasureKind } from "./tables/measures.ts";

export {
  type KindInfo,
  kindInfo,
  kindOfWire,
  kKinds,
  type MeasureKind,
  type Shape,
} from "./tables/measures.ts";

export function keywordOf(kind: MeasureKind): string {
  return kindInfo(kind).keyword;
}

/** Those that FOLLOW takes. */
export const kLineKinds: ReadonlySet<MeasureKind> = new Set(kKinds.filter((k) => k.isLine).map((k) => k.kind));
